// The header of a PLY file, checked line by line: OpenMesh 9 crashes on some that are malformed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace relievo {

struct PlyHeader {
    std::string text;  // without comments, texture coordinates named as OpenMesh knows them
    std::size_t original_lines = 0, original_bytes = 0, lines = 0;
    bool ascii = false;
    bool doubles = false;     // positions in double precision
    bool corner_uvs = false;  // faces carry a list 'texcoord'
};

// Throws std::invalid_argument naming the file and the line.
PlyHeader read_ply_header(const std::filesystem::path& path, std::string_view bytes);

}  // namespace relievo
