// See extreme_meshes.h.
#include "renderer/stability/extreme_meshes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "renderer/stability/sample_surfaces.h"

namespace relievo::stability {
namespace {

using glm::dvec2;
using glm::dvec3;

// One uv a position; smooth normals.
Mesh mesh_of(const std::vector<dvec3>& positions, const std::vector<dvec2>& uvs,
             const std::vector<std::array<std::uint32_t, 3>>& faces) {
    MeshFile file;
    file.positions = positions;
    file.uvs = uvs;
    for (const auto& face : faces) file.faces.push_back({face, face});
    return make_mesh(file, glm::dmat4(1), dvec3(0), false);
}

std::vector<dvec2> uvs_by_place(const std::vector<dvec3>& positions) {
    std::vector<dvec2> uvs;
    for (const dvec3& p : positions) uvs.emplace_back(p.x / 4 + 0.5, p.y / 4 + 0.5 + p.z / 16);
    return uvs;
}

std::uint32_t whole(int value) {
    return static_cast<std::uint32_t>(value);
}

}  // namespace

Mesh ribbon_mesh(int count, double width) {
    std::vector<dvec3> positions;
    std::vector<dvec2> uvs;
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (int i = 0; i <= count; ++i) {
        for (int end = 0; end < 2; ++end) {
            // Out of the axes, so that no coordinate is 0.
            const double x = end, y = i * width;
            positions.emplace_back(x - 0.3 * y, y + 0.3 * x, 0.1 * x);
            uvs.emplace_back(x, double(i) / count);
        }
        if (i == count) break;
        const std::uint32_t a = whole(2 * i);
        faces.push_back({a, a + 1, a + 3});
        faces.push_back({a, a + 3, a + 2});
    }
    return mesh_of(positions, uvs, faces);
}

Mesh needle_fan_mesh(int needles, double width) {
    constexpr int kBroad = 20;
    std::vector<dvec3> positions{{0, 0, 0}};
    std::vector<dvec2> uvs{{0.5, 0.5}};
    std::vector<std::array<std::uint32_t, 3>> faces;
    double angle = 0;
    for (int i = 0; i <= needles + kBroad; ++i) {
        const double x = std::cos(angle), y = std::sin(angle);
        positions.emplace_back(x, y, 0.05 * std::sin(9 * angle));
        uvs.emplace_back(0.5 + 0.5 * x, 0.5 + 0.5 * y);
        if (i > 0) faces.push_back({0, whole(i), whole(i + 1)});
        angle += i < needles ? width : 0.15;
    }
    return mesh_of(positions, uvs, faces);
}

Mesh wedge_mesh(double degrees) {
    const double half = glm::radians(degrees) / 2;
    const std::vector<dvec3> positions = {{0, 0, 0},
                                          {0, 1, 0},
                                          {-std::cos(half), 0.5, std::sin(half)},
                                          {-std::cos(half), 0.5, -std::sin(half)}};
    return mesh_of(positions, uvs_by_place(positions), {{0, 1, 2}, {1, 0, 3}});
}

Mesh blade_mesh(double degrees, int segments) {
    const double half = glm::radians(degrees) / 2;
    std::vector<dvec3> positions;
    for (int i = 0; i <= segments; ++i) {
        const double y = double(i) / segments;
        positions.insert(
            positions.end(),
            {{0, y, 0}, {-std::cos(half), y, std::sin(half)}, {-std::cos(half), y, -std::sin(half)}});
    }
    const std::uint32_t last = whole(3 * segments);
    std::vector<std::array<std::uint32_t, 3>> faces = {{0, 1, 2}, {last, last + 2, last + 1}};
    for (std::uint32_t i = 0; i < whole(segments); ++i) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = 3 * i + k, b = 3 * i + (k + 1) % 3;
            faces.push_back({a, a + 3, b});
            faces.push_back({b, a + 3, b + 3});
        }
    }
    return mesh_of(positions, uvs_by_place(positions), faces);
}

Mesh book_mesh(int sheets) {
    std::vector<dvec3> positions = {{0, 0, -0.5}, {0, 0, 0.5}};
    std::vector<dvec2> uvs = {{0, 0}, {0, 1}};
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (int i = 0; i < sheets; ++i) {
        const double angle = glm::radians(20.0 + 50.0 * i);
        const std::uint32_t low = whole(2 + 2 * i), high = low + 1;
        positions.emplace_back(std::cos(angle), std::sin(angle), -0.5);
        positions.emplace_back(std::cos(angle), std::sin(angle), 0.5);
        uvs.emplace_back(1, 0);
        uvs.emplace_back(1, 1);
        faces.push_back({0, low, high});
        faces.push_back({0, high, 1});
    }
    return mesh_of(positions, uvs, faces);
}

Mesh with_holes(Mesh mesh) {
    std::vector<Mesh::Face> kept;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        if (i % 3 != 1) kept.push_back(mesh.faces[i]);
    mesh.faces = std::move(kept);
    return mesh;
}

Mesh unwelded(const Mesh& mesh) {
    Mesh apart = mesh;
    apart.positions.clear();
    apart.normals.clear();
    for (Mesh::Face& face : apart.faces) {
        for (std::uint32_t& corner : face.position) {
            apart.positions.push_back(mesh.positions[corner]);
            apart.normals.push_back(mesh.normals[corner]);
            corner = static_cast<std::uint32_t>(apart.positions.size() - 1);
        }
    }
    return apart;
}

Mesh with_zero_area_faces(Mesh mesh) {
    const std::vector<Mesh::Face> faces = mesh.faces;
    for (std::size_t i = 0; i < faces.size(); i += 7) {
        const Mesh::Face& f = faces[i];
        mesh.faces.push_back({{f.position[0], f.position[0], f.position[1]}, {f.uv[0], f.uv[0], f.uv[1]}});
        mesh.faces.push_back({{f.position[2], f.position[2], f.position[2]}, f.uv});
        mesh.positions.push_back((mesh.positions[f.position[0]] + mesh.positions[f.position[1]]) * 0.5f);
        mesh.normals.push_back(mesh.normals[f.position[0]]);
        const auto middle = static_cast<std::uint32_t>(mesh.positions.size() - 1);
        mesh.faces.push_back({{f.position[0], middle, f.position[1]}, f.uv});
    }
    return mesh;
}

Mesh turned_inside_out(Mesh mesh) {
    for (Mesh::Face& face : mesh.faces) {
        std::swap(face.position[1], face.position[2]);
        std::swap(face.uv[1], face.uv[2]);
    }
    return mesh;
}

Mesh transformed(const Mesh& mesh, const glm::dmat4& world_from_object) {
    MeshFile file;
    for (const glm::vec3& p : mesh.positions) file.positions.emplace_back(p);
    for (const glm::vec3& n : mesh.normals) file.file_normals.emplace_back(n);
    for (const glm::vec2& uv : mesh.uvs) file.uvs.emplace_back(uv);
    file.faces = mesh.faces;
    return make_mesh(file, world_from_object, dvec3(0), true);
}

Mesh with_leaning_normals(Mesh mesh) {
    for (std::uint32_t i = 0; i < mesh.normals.size(); i += 5) {
        const glm::vec3 side(hash01(i, 0, 11) - 0.5, hash01(i, 1, 11) - 0.5, hash01(i, 2, 11) - 0.5);
        mesh.normals[i] = glm::normalize(mesh.normals[i] + 1.5f * glm::normalize(side));
    }
    return mesh;
}

Mesh with_overlapping_uvs(Mesh mesh) {
    mesh.uvs = {{0, 0}, {1, 0}, {0, 1}};
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        mesh.faces[i].uv =
            i % 2 == 0 ? std::array<std::uint32_t, 3>{0, 1, 2} : std::array<std::uint32_t, 3>{0, 2, 1};
    return mesh;
}

}  // namespace relievo::stability
