// The nearest point of the base mesh. A triangle's nearest point after C. Ericson, "Real-Time Collision
// Detection", 2005, section 5.1.5.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>

#include "editor/session/surface/mesh_surface.h"
#include "editor/session/surface/texel_triangle.h"

namespace relievo {
namespace {

// Barycentrics (b1, b2) of the triangle's point nearest to p.
glm::dvec2 nearest_barycentrics(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    const glm::dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return {0, 0};
    const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return {1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {d1 / (d1 - d3), 0};
    const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return {0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {0, d2 / (d2 - d6)};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {1 - w, w};
    }
    const double all = va + vb + vc;
    return {vb / all, vc / all};
}

}  // namespace

FacePoint MeshSurface::nearest_on_base(glm::dvec3 place) const {
    FacePoint best;
    double least = std::numeric_limits<double>::infinity();
    const double size = std::max(static_cast<double>(mesh_.sphere_radius), 1e-30);
    const double away = glm::length(place - glm::dvec3(mesh_.sphere_centre));
    for (double radius = 0.01 * size;; radius *= 4) {
        std::vector<std::uint32_t> faces;
        tree_.near(glm::vec3(place), static_cast<float>(radius), faces);
        std::sort(faces.begin(), faces.end());
        for (const std::uint32_t face : faces) {
            const auto& p = mesh_.faces[face].position;
            const glm::dvec3 a(mesh_.positions[p[0]]), b(mesh_.positions[p[1]]), c(mesh_.positions[p[2]]);
            const glm::dvec2 at = nearest_barycentrics(place, a, b, c);
            const double way = glm::length(a + at.x * (b - a) + at.y * (c - a) - place);
            if (!(way < least)) continue;
            least = way;
            constexpr double kOne = Dab::kBarycentricOne;
            best.face = face;
            best.b1 = static_cast<std::uint32_t>(std::llround(std::clamp(at.x, 0.0, 1.0) * kOne));
            best.b2 = std::min(static_cast<std::uint32_t>(std::llround(std::clamp(at.y, 0.0, 1.0) * kOne)),
                               Dab::kBarycentricOne - best.b1);
        }
        if (least <= radius || !(radius < 4 * (away + size))) return best;
    }
}

double MeshSurface::texel_size(std::uint32_t face) const {
    const double texels = std::abs(texel_triangle(mesh_, face, grid_).doubled_area());
    const auto& p = mesh_.faces[face].position;
    const glm::dvec3 a(mesh_.positions[p[0]]), b(mesh_.positions[p[1]]), c(mesh_.positions[p[2]]);
    const double area = glm::length(glm::cross(b - a, c - a));
    return texels > 0 ? std::sqrt(area / texels) : 0;
}

}  // namespace relievo
