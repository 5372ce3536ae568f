// Opacity maps: 8-bit images that cut holes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace relievo {

struct OpacityMap {
    int width = 1, height = 1;
    std::vector<std::uint8_t> texels{255};  // row 0 at v = 0; 0 is a hole, 255 is solid
};

// The image's alpha, or its first channel when it has none. std::invalid_argument names the file and what is wrong.
OpacityMap load_opacity_map(const std::filesystem::path& path);

}  // namespace relievo
