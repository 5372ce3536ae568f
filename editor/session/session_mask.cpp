// See session_mask.h.
#include "editor/session/session_mask.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <system_error>

#include "brushes/map_file.h"
#include "editor/session/memory_estimate.h"

namespace relievo {
namespace fs = std::filesystem;

fs::path mask_path_beside(const fs::path& height_map) {
    return fs::path(height_map).concat(".mask.png");
}

HeightMap load_mask(const fs::path& path, int width, int height, const Advance& advance) {
    const MapInfo info = map_info(path);
    if (info.width != width || info.height != height)
        throw std::invalid_argument("mask '" + path.string() + "': has " + std::to_string(info.width) + " x " +
                                    std::to_string(info.height) + " texels, its map " + std::to_string(width) + " x " +
                                    std::to_string(height));
    require_memory(path, info, estimate_memory(info, false, MapBounds::none), available_memory());
    return load_map(path, {}, advance).map;
}

bool protects_anything(const HeightMap& mask) {
    return std::ranges::any_of(mask.texels(), [](std::uint16_t texel) { return texel > 0; });
}

void save_mask(const HeightMap* mask, const fs::path& path, const Advance& advance) {
    if (mask && protects_anything(*mask)) return save_map(*mask, path, MapFormat::png16, {}, nullptr, advance);
    std::error_code error;
    fs::remove(path, error);
    if (error) throw std::invalid_argument("cannot remove '" + path.string() + "': " + error.message());
}

}  // namespace relievo
