// The base mesh: what rays, bounds and brushes share.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace relievo {

// Positions are world space (the object's transform is baked in, because amplitude and dt are world lengths)
// minus the scene's origin, which is subtracted in double so that scenes far from 0 keep their digits.
struct Mesh {
    struct Face {
        std::array<std::uint32_t, 3> position;  // into positions and normals
        std::array<std::uint32_t, 3> uv;        // into uvs
    };
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  // unit, one a position (DESIGN.md section 1)
    std::vector<glm::vec2> uvs;      // (0,0) is the image's lower left corner; any range
    std::vector<Face> faces;         // counter-clockwise seen from outside

    glm::vec3 bounds_low{0}, bounds_high{0};  // of the base positions
    glm::vec3 sphere_centre{0};
    float sphere_radius = 0;            // bounding sphere of the base positions: the unit of dt
    std::vector<std::string> warnings;  // dropped or mended input, one sentence each
};

// Raw data of a mesh file before transform and rebasing. Polygons are triangulated, identical positions and
// identical uvs are welded (bit for bit), positions that no face uses are left out, faces keep the file's
// order.
struct MeshFile {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> file_normals;  // unit; empty, or one a position
    std::vector<glm::dvec2> uvs;
    std::vector<Mesh::Face> faces;
    std::vector<std::string> warnings;
    std::filesystem::path path;       // for messages
    std::string why_no_file_normals;  // a sentence when the file has normals that cannot be used, else empty
};

// Reads OBJ, PLY, STL or OFF. Throws std::invalid_argument naming the file (and line or face where known) for
// a missing or unreadable file, no faces, no texture coordinates, NaN or infinite numbers, indices out of
// range.
MeshFile load_mesh_file(const std::filesystem::path& path);

// Applies the transform, subtracts the origin, makes normals: the file's where `use_file_normals` and it has
// them, else area-weighted over all triangles that share the position. A mirroring transform flips the faces.
// Throws std::invalid_argument when positions leave the range of float.
Mesh make_mesh(const MeshFile& file, const glm::dmat4& world_from_object, const glm::dvec3& origin,
               bool use_file_normals);

// Recomputes bounds_low to sphere_radius from the positions: the sphere stands around the centre of the
// bounds.
void measure_bounds(Mesh& mesh);

// A face without area (height under 1e-9 of its longest edge): S is degenerate on it, nothing renders it.
bool has_no_area(const Mesh& mesh, const Mesh::Face& face);

}  // namespace relievo
