#include "editor/session/surface/mesh_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "editor/session/surface/seam_table.h"

namespace relievo {
namespace {

// Lengths below this count as zero when a direction is made of them; its square is a normal double.
constexpr double kNoLength = 1e-140;

bool usable(glm::dvec3 v) {
    const double length = glm::length(v);
    return length > kNoLength && std::isfinite(length);
}

MeshSurface::NormalCone normal_cone(const Mesh& mesh, const Mesh::Face& face) {
    glm::dvec3 axis(0);
    for (const std::uint32_t p : face.position) axis += glm::dvec3(mesh.normals[p]);
    if (glm::length(axis) < 1e-3) return {{0, 0, 1}, 1, -1};
    axis = glm::normalize(axis);
    double cosine = 1;
    for (const std::uint32_t p : face.position)
        cosine = std::min(cosine, glm::dot(axis, glm::dvec3(mesh.normals[p])));
    cosine -= 1e-6;
    const double spread = cosine <= 0 ? 1 : std::sqrt(std::max(0.0, 1 - cosine * cosine));
    return {glm::vec3(axis), static_cast<float>(spread), static_cast<float>(cosine)};
}

}  // namespace

MeshSurface::MeshSurface(const Mesh& mesh, const Displacement& displacement, const HeightMap& map)
    : mesh_(mesh),
      map_(map),
      grid_{map.width(), map.height(), displacement.wrap},
      tree_(mesh),
      owned_(mesh, grid_),
      seams_(build_seam_table(mesh, grid_, owned_)) {
    set_displacement(displacement.amplitude, displacement.midlevel);
    cones_.reserve(mesh.faces.size());
    for (const Mesh::Face& face : mesh.faces) cones_.push_back(normal_cone(mesh, face));
}

void MeshSurface::set_displacement(double amplitude, double midlevel) {
    amplitude_ = static_cast<float>(amplitude);
    midlevel_ = static_cast<float>(midlevel);
}

std::uint32_t MeshSurface::face_count() const {
    return static_cast<std::uint32_t>(mesh_.faces.size());
}

bool MeshSurface::owned(int x, int y) const {
    return owned_(static_cast<std::uint32_t>(map_.index(x, y)));
}

glm::vec3 MeshSurface::fallback_normal(std::uint32_t face) const {
    const auto& p = mesh_.faces[face].position;
    const glm::dvec3 a(mesh_.positions[p[0]]), b(mesh_.positions[p[1]]), c(mesh_.positions[p[2]]);
    const glm::dvec3 geometric = glm::cross(b - a, c - a);
    if (usable(geometric)) return glm::vec3(glm::normalize(geometric));
    const glm::dvec3 corner(mesh_.normals[p[0]]);
    return usable(corner) ? glm::vec3(glm::normalize(corner)) : glm::vec3(0, 0, 1);
}

SurfacePoint MeshSurface::at(std::uint32_t face, float b1, float b2) const {
    const Mesh::Face& f = mesh_.faces[face];
    const double v = static_cast<double>(b1), w = static_cast<double>(b2), u = 1 - v - w;
    std::array<glm::dvec3, 3> p, n;
    std::array<glm::dvec2, 3> t;
    for (std::size_t i = 0; i < 3; ++i) {
        p[i] = glm::dvec3(mesh_.positions[f.position[i]]);
        n[i] = glm::dvec3(mesh_.normals[f.position[i]]);
        t[i] = grid_.texel_from_uv(mesh_.uvs[f.uv[i]]);
    }
    const BilinearTaps taps = bilinear_taps(grid_, u * t[0] + v * t[1] + w * t[2]);
    std::array<double, 4> count;
    for (std::size_t i = 0; i < 4; ++i) count[i] = map_.texels()[taps.texel[i]];
    const double scale = static_cast<double>(amplitude_) / 65535;
    const double height = scale * bilinear(map_.texels(), taps) -
                          static_cast<double>(amplitude_) * static_cast<double>(midlevel_);
    const glm::dvec2 slope =
        scale * glm::dvec2((1 - taps.fy) * (count[1] - count[0]) + taps.fy * (count[3] - count[2]),
                           (1 - taps.fx) * (count[2] - count[0]) + taps.fx * (count[3] - count[1]));

    const glm::dvec3 sum = u * n[0] + v * n[1] + w * n[2];
    const double length = glm::length(sum);
    const bool has_normal = usable(sum);
    const glm::dvec3 unit = has_normal ? sum / length : glm::dvec3(fallback_normal(face));
    const auto tangent = [&](std::size_t i) {  // dS / db_i
        const glm::dvec3 dn = n[i] - n[0];
        const glm::dvec3 turn = has_normal ? (dn - unit * glm::dot(unit, dn)) / length : glm::dvec3(0);
        return p[i] - p[0] + glm::dot(slope, t[i] - t[0]) * unit + height * turn;
    };
    const glm::dvec3 base = u * p[0] + v * p[1] + w * p[2];
    SurfacePoint point{glm::vec3(base + height * unit), glm::vec3(unit), glm::vec3(base), glm::vec3(unit)};
    const glm::dvec3 geometric = glm::cross(tangent(1), tangent(2));
    if (usable(geometric)) {
        const glm::dvec3 normal = glm::normalize(geometric);
        point.normal = glm::vec3(glm::dot(normal, unit) < 0 ? -normal : normal);
    }
    return point;
}

}  // namespace relievo
