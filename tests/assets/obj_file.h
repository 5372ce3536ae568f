// The sample assets' own OBJ dialect (v, vt, vn, and f v/vt/vn triangles), read strictly: a test of the files
// must not share a reader that mends them.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace relievo::assets_test {

struct Corner {
    std::size_t position, uv, normal;  // from 0
};

struct ObjFile {
    std::vector<glm::dvec3> positions, normals;
    std::vector<glm::dvec2> uvs;
    std::vector<std::array<Corner, 3>> faces;
};

// Throws std::runtime_error on anything outside the dialect.
ObjFile read_obj(const std::filesystem::path& path);

// A single-channel image as counts, row 0 at the bottom; `side` texels a side. Throws when it is not 8 or 16
// bits wide.
struct MapFile {
    int side = 0;
    int bits = 0;
    std::vector<unsigned short> counts;

    // Bilinear between texel centres, clamped at the border; exact for uv that are multiples of 2^-20.
    double bilinear(glm::dvec2 uv) const;
};
MapFile read_map(const std::filesystem::path& path);

}  // namespace relievo::assets_test
