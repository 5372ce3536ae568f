// See surface_hull.h.
#include "renderer/surface_hull.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <span>

namespace relievo {
namespace {

using glm::dvec3;

std::span<const glm::vec3> points_of(const SurfaceHull& hull) {
    return std::span(hull.points).first(hull.count);
}

void add(SurfaceHull& hull, const dvec3& point) {
    hull.points[hull.count++] = glm::vec3(point);
}

constexpr double kUnitRounding = 1e-6;  // of squares of lengths

glm::vec3 facing_of(const dvec3& a, const dvec3& b, const dvec3& c) {
    return glm::vec3(glm::cross(b - a, c - a));
}

}  // namespace

std::array<dvec3, 3> corners_of(const gpu::Primitive& p) {
    const dvec3 tangent = p.tangent, bitangent = glm::cross(dvec3(p.ng), tangent), origin = p.origin;
    return {origin, origin + tangent * double{p.q1x}, origin + tangent * double{p.q2.x} + bitangent * double{p.q2.y}};
}

UnitNormal unit_normal(const gpu::PrimitiveNormals& n) {
    const std::array<dvec3, 3> normals{n.n0, n.n1, n.n2};
    // |N|^2 = sum b_i |N_i|^2 - sum b_i b_j |N_i - N_j|^2, and the b_i b_j sum to a third at most. No N_i is longer than 1.
    double apart = 0, least = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        apart = std::max(apart, glm::length(normals[i] - normals[(i + 1) % 3]));
        least = std::min(least, glm::length(normals[i]));
    }
    const double square = least * least - apart * apart / 3 - kUnitRounding;
    if (!(square > 0)) return {0, 1};
    const double shortest = std::sqrt(square);
    return {2 / (shortest + 1), (1 - shortest) / (1 + shortest) + kUnitRounding};
}

SurfaceHull prism_hull(const gpu::Primitive& p) {
    const dvec3 tangent = p.tangent, bitangent = glm::cross(dvec3(p.ng), tangent);
    SurfaceHull hull;
    for (const float w : {p.w_low, p.w_high})
        for (const glm::vec2& q : {p.shift0 * w, glm::vec2(p.q1x, 0) + p.shift1 * w, p.q2 + p.shift2 * w})
            add(hull, dvec3(p.origin) + tangent * double{q.x} + bitangent * double{q.y} + dvec3(p.ng) * double{w});
    if (p.shell_margin > 0) {
        glm::vec3 low(1e30f), high(-1e30f);
        for (const glm::vec3& point : points_of(hull)) low = glm::min(low, point), high = glm::max(high, point);
        hull.radius = 2 * p.shell_margin * glm::length(high - low);
    }
    hull.facing = p.ng * (p.q1x * p.q2.y);
    return hull;
}

SurfaceHull surface_hull(const gpu::Primitive& p, const gpu::PrimitiveNormals& n, const DisplacementRange& range) {
    const std::array<dvec3, 3> normals{n.n0, n.n1, n.n2}, corners = corners_of(p);
    const UnitNormal unit = unit_normal(n);
    SurfaceHull hull;
    for (const double d : {range.low, range.high})
        for (std::size_t i = 0; i < 3; ++i) add(hull, corners[i] + normals[i] * (d * unit.scale));
    hull.radius = static_cast<float>(std::max(std::abs(range.low), std::abs(range.high)) * unit.off);
    hull.facing = p.ng * (p.q1x * p.q2.y);
    return hull;
}

SurfaceHull surface_hull(const gpu::Primitive& p, const gpu::PrimitiveNormals& n, const DisplacementPlane& plane) {
    const std::array<dvec3, 3> normals{n.n0, n.n1, n.n2}, corners = corners_of(p);
    const UnitNormal unit = unit_normal(n);
    SurfaceHull hull;
    double most = 0;
    for (const double r : {plane.low, plane.high}) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const double di = plane.corner[i] + r, dj = plane.corner[j] + r;
            add(hull, corners[i] + normals[i] * (di * unit.scale));
            add(hull, (corners[i] + corners[j] + (normals[j] * di + normals[i] * dj) * unit.scale) / 2.0);
            most = std::max(most, std::abs(di));
        }
    }
    hull.radius = static_cast<float>(most * unit.off);
    std::array<dvec3, 3> displaced;
    for (std::size_t i = 0; i < 3; ++i)
        displaced[i] = corners[i] + normals[i] * ((plane.corner[i] + (plane.low + plane.high) / 2) * unit.scale);
    hull.facing = facing_of(displaced[0], displaced[1], displaced[2]);
    return hull;
}

Box box_of(const SurfaceHull& hull) {
    Box box{glm::vec3(1e30f), glm::vec3(-1e30f)};
    for (const glm::vec3& point : points_of(hull)) {
        box.low = glm::min(box.low, point - hull.radius);
        box.high = glm::max(box.high, point + hull.radius);
    }
    return with_rounding(box);
}

Box prism_box(const gpu::Primitive& p) {
    return box_of(prism_hull(p));
}

Box overlap(const Box& a, const Box& b) {
    return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

Box surface_box(const gpu::Primitive& p, const gpu::PrimitiveNormals& n, const DisplacementRange& range) {
    const Box box = box_of(surface_hull(p, n, range));
    if ((p.flags & gpu::kPrimitiveSearched) != 0) return box;
    // S also stays near the prism, whose box is the narrower one where the normals are spread.
    return overlap(box, prism_box(p));
}

Extent extent_along(const SurfaceHull& hull, const dvec3& direction, const dvec3& origin) {
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    if (hull.count == 0) return {-kEndless, kEndless};
    Extent extent{kEndless, -kEndless};
    dvec3 low(kEndless), high(-kEndless);
    for (const glm::vec3& point : points_of(hull)) {
        const double at = glm::dot(dvec3(point) - origin, direction);
        if (!std::isfinite(at)) return {-kEndless, kEndless};
        extent = {std::min(extent.low, at), std::max(extent.high, at)};
        low = glm::min(low, dvec3(point));
        high = glm::max(high, dvec3(point));
    }
    const double beyond =
        (hull.radius + kRoundingOfSize * glm::length(high - low)) * glm::length(direction) +
        kRoundingOfCoordinates * glm::dot(glm::max(glm::abs(low), glm::abs(high)), glm::abs(direction));
    return {extent.low - beyond, extent.high + beyond};
}

}  // namespace relievo
