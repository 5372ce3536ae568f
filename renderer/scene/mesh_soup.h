// Polygons as a mesh file lists them, before welding: no topology, so that non-manifold edges, duplicate
// vertices and faces without area survive.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/scene/mesh.h"

namespace relievo {

struct MeshSoup {
    struct Corner {
        std::int64_t position;
        std::int64_t uv = -1, normal = -1;  // -1: none
    };
    std::vector<glm::dvec3> positions, normals;
    std::vector<glm::dvec2> uvs;
    std::vector<Corner> corners;
    std::vector<std::size_t> face_ends;  // polygon k is corners [face_ends[k - 1], face_ends[k])
    std::vector<std::string> warnings;
    std::string no_uv_hint;  // replaces the usual advice when there are no texture coordinates
};

// Readers. `bytes` is the whole file; all throw std::invalid_argument naming `path` and line where known.
MeshSoup read_obj(const std::filesystem::path& path, std::string_view bytes);
MeshSoup read_ply(const std::filesystem::path& path, const std::string& bytes);
MeshSoup read_off(const std::filesystem::path& path, std::string_view bytes);

// Triangulates, welds, compacts and checks: the second half of load_mesh_file.
MeshFile weld_soup(const std::filesystem::path& path, const MeshSoup& soup);

// Cuts a polygon into size - 2 triangles of corner indices, by ears; a convex one becomes the fan around
// corner 0. Polygons of more than 256 corners are fanned unseen.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const glm::dvec3> polygon);

}  // namespace relievo
