// make_mesh: transform, rebasing, normals, bounds.
#include "renderer/scene/mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <stdexcept>

namespace relievo {

namespace {

// A sum of face normals shorter than this part of what it adds up is a cancellation, not a direction.
constexpr double kCancelled = 1e-9;
// Height over longest edge under which a face counts as one without area.
constexpr double kFlatness = 1e-9;

// Area-weighted normals over all faces that share a position. Where they cancel (a folded sheet, a point
// between opposite faces) the largest face decides; where no face has an area, +Z.
std::vector<glm::vec3> smooth_normals(const std::vector<glm::dvec3>& positions,
                                      const std::vector<Mesh::Face>& faces) {
    struct Sum {
        glm::dvec3 normal{0}, largest{0};
        double area = 0, largest_area = 0;
    };
    std::vector<Sum> sums(positions.size());
    for (const Mesh::Face& face : faces) {
        const auto [a, b, c] = face.position;
        const glm::dvec3 normal = glm::cross(positions[b] - positions[a], positions[c] - positions[a]);
        const double area = glm::length(normal);
        for (const std::uint32_t p : face.position) {
            Sum& sum = sums[p];
            sum.normal += normal;
            sum.area += area;
            if (area > sum.largest_area) sum.largest = normal, sum.largest_area = area;
        }
    }
    std::vector<glm::vec3> normals;
    normals.reserve(sums.size());
    for (const Sum& sum : sums) {
        glm::dvec3 normal = sum.normal;
        if (!(glm::length(normal) > kCancelled * sum.area)) normal = sum.largest;
        normals.emplace_back(sum.largest_area > 0 ? glm::normalize(normal) : glm::dvec3(0, 0, 1));
    }
    return normals;
}

// By the cofactors: the inverse transpose up to a positive factor once the determinant's sign is put back,
// and without a division.
std::vector<glm::vec3> transformed_normals(const MeshFile& file, const glm::dmat3& m, bool mirrored) {
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    std::vector<glm::vec3> normals;
    normals.reserve(file.file_normals.size());
    for (const glm::dvec3& n : file.file_normals) {
        normals.emplace_back(glm::normalize(mirrored ? -(cofactors * n) : cofactors * n));
    }
    return normals;
}

void warn_of_flat_faces(Mesh& mesh) {
    const auto flat = static_cast<std::size_t>(std::count_if(
        mesh.faces.begin(), mesh.faces.end(), [&](const Mesh::Face& f) { return has_no_area(mesh, f); }));
    if (flat == 0) return;
    mesh.warnings.push_back(std::to_string(flat) + " of " + std::to_string(mesh.faces.size()) +
                            " triangles have no area; they are kept but not rendered");
}

}  // namespace

Mesh make_mesh(const MeshFile& file, const glm::dmat4& world_from_object, const glm::dvec3& origin,
               bool use_file_normals) {
    const glm::dmat3 linear(world_from_object);
    const bool mirrored = glm::determinant(linear) < 0;
    Mesh mesh;
    mesh.warnings = file.warnings;
    mesh.faces = file.faces;
    if (mirrored) {
        for (Mesh::Face& face : mesh.faces) {
            std::swap(face.position[1], face.position[2]);
            std::swap(face.uv[1], face.uv[2]);
        }
    }
    std::vector<glm::dvec3> world;
    world.reserve(file.positions.size());
    constexpr double kLargest = std::numeric_limits<float>::max() / 4;
    for (const glm::dvec3& p : file.positions) {
        world.push_back(glm::dvec3(world_from_object * glm::dvec4(p, 1)) - origin);
        if (!(glm::length(world.back()) < kLargest)) {
            throw std::invalid_argument(file.path.string() +
                                        ": a position lies beyond the range of numbers; scale " +
                                        "the mesh down");
        }
        mesh.positions.emplace_back(world.back());
    }
    for (const glm::dvec2& uv : file.uvs) {
        if (!(glm::length(uv) < kLargest)) {
            throw std::invalid_argument(file.path.string() +
                                        ": a texture coordinate lies beyond the range of numbers");
        }
        mesh.uvs.emplace_back(uv);
    }
    if (use_file_normals && !file.file_normals.empty()) {
        mesh.normals = transformed_normals(file, linear, mirrored);
    } else {
        mesh.normals = smooth_normals(world, mesh.faces);
        if (use_file_normals && !file.why_no_file_normals.empty())
            mesh.warnings.push_back(file.why_no_file_normals);
    }
    measure_bounds(mesh);
    warn_of_flat_faces(mesh);
    return mesh;
}

void measure_bounds(Mesh& mesh) {
    if (mesh.positions.empty()) return;
    mesh.bounds_low = mesh.bounds_high = mesh.positions[0];
    for (const glm::vec3& p : mesh.positions) {
        for (int k = 0; k < 3; ++k) {
            mesh.bounds_low[k] = std::min(mesh.bounds_low[k], p[k]);
            mesh.bounds_high[k] = std::max(mesh.bounds_high[k], p[k]);
        }
    }
    mesh.sphere_centre = glm::vec3((glm::dvec3(mesh.bounds_low) + glm::dvec3(mesh.bounds_high)) * 0.5);
    double radius = 0;
    for (const glm::vec3& p : mesh.positions) {
        radius = std::max(radius, glm::length(glm::dvec3(p) - glm::dvec3(mesh.sphere_centre)));
    }
    mesh.sphere_radius = static_cast<float>(radius);
    if (static_cast<double>(mesh.sphere_radius) < radius) {
        mesh.sphere_radius = std::nextafter(mesh.sphere_radius, std::numeric_limits<float>::infinity());
    }
}

bool has_no_area(const Mesh& mesh, const Mesh::Face& face) {
    const glm::dvec3 a(mesh.positions[face.position[0]]), b(mesh.positions[face.position[1]]),
        c(mesh.positions[face.position[2]]);
    const double longest = std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
    return !(glm::length(glm::cross(b - a, c - a)) > kFlatness * longest);
}

}  // namespace relievo
