// Albedo maps on disk, as rendering alone needs them: the texels, and nothing else of the file.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "renderer/renderer.h"

namespace relievo {

struct AlbedoFile {
    int width = 0, height = 0, bits = 8;
    std::array<std::vector<std::uint16_t>, 3> planes;  // as ColourView has them
    ColourView view() const {
        return {width, height, bits, {planes[0].data(), planes[1].data(), planes[2].data()}};
    }
};

// The first three channels of a PNG or TIFF of 8 or 16 bits, widened to 16 and taken as sRGB-encoded; alpha
// is not read. std::invalid_argument names the file and what is wrong: not an image, fewer than three
// channels, another type of value, more than 16384 texels a side, cut off.
AlbedoFile load_albedo_file(const std::filesystem::path& path);

}  // namespace relievo
