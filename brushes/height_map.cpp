// The texels of a displacement map, and the hash by which journals recognise them.
#include "brushes/height_map.h"

#include <stdexcept>
#include <string>

#include "brushes/fnv.h"

namespace relievo {
namespace {

std::size_t texel_count(int width, int height) {
    if (width < 1 || height < 1 || width > HeightMap::kMaxSize || height > HeightMap::kMaxSize)
        throw std::invalid_argument("a displacement map of " + std::to_string(width) + " x " +
                                    std::to_string(height) + " texels: each side must be 1 to " +
                                    std::to_string(HeightMap::kMaxSize));
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace

HeightMap::HeightMap(int width, int height, std::uint16_t fill)
    : width_(width), height_(height), texels_(texel_count(width, height), fill) {}

std::uint64_t HeightMap::hash() const {
    Fnv1a64 hash;
    hash.add_little_endian(static_cast<std::uint32_t>(width_));
    hash.add_little_endian(static_cast<std::uint32_t>(height_));
    for (const std::uint16_t texel : texels_) hash.add_little_endian(texel);
    return hash.value();
}

}  // namespace relievo
