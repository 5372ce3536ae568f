// See ray_frame.h. The hull's distance from the axis by the algorithm of Gilbert, Johnson and Keerthi (1988),
// in the plane across the ray; what it returns rests on the separating lines it meets, not on its
// convergence.
#include "renderer/reference/ray_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "renderer/scene/cross2.h"

namespace relievo::reference {
namespace {

using glm::dvec2;
using glm::dvec3;

dvec2 nearest_on_segment(const dvec2& a, const dvec2& b) {
    const dvec2 e = b - a;
    const double square = glm::dot(e, e);
    if (!(square > 0)) return a;
    return a + e * std::clamp(-glm::dot(a, e) / square, 0.0, 1.0);
}

// Up to three points whose hull holds the nearest point found so far.
struct Simplex {
    std::array<dvec2, 3> points;
    int count = 0;

    // Keeps the points that the nearest point to 0 needs, and returns it.
    dvec2 reduce() {
        if (count == 1) return points[0];
        if (count == 2) return nearest_on_segment(points[0], points[1]);
        const double a = cross2(points[0], points[1]), b = cross2(points[1], points[2]),
                     c = cross2(points[2], points[0]);
        if ((a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0)) return dvec2(0);
        dvec2 best(0);
        double best_square = -1;
        int dropped = 0;
        for (int i = 0; i < 3; ++i) {
            const dvec2 on_side = nearest_on_segment(points[static_cast<std::size_t>((i + 1) % 3)],
                                                     points[static_cast<std::size_t>((i + 2) % 3)]);
            const double square = glm::dot(on_side, on_side);
            if (best_square < 0 || square < best_square) best = on_side, best_square = square, dropped = i;
        }
        points[static_cast<std::size_t>(dropped)] = points[2];
        count = 2;
        return best;
    }
};

}  // namespace

RayFrame::RayFrame(const dvec3& origin, const dvec3& unit) : origin_(origin), z_(unit) {
    const dvec3 size = glm::abs(unit);
    const dvec3 other = size.x <= size.y && size.x <= size.z ? dvec3(1, 0, 0)
                        : size.y <= size.z                   ? dvec3(0, 1, 0)
                                                             : dvec3(0, 0, 1);
    x_ = glm::normalize(glm::cross(other, unit));
    y_ = glm::cross(unit, x_);
}

dvec3 RayFrame::turn(const dvec3& vector) const {
    return {glm::dot(x_, vector), glm::dot(y_, vector), glm::dot(z_, vector)};
}

bool axis_meets_hull(std::span<const dvec3> points, double radius) {
    constexpr int kMostSteps = 16;
    Simplex simplex;
    simplex.points[0] = dvec2(points[0]);
    simplex.count = 1;
    for (int step = 0; step < kMostSteps; ++step) {
        const dvec2 nearest = simplex.reduce();
        const double length = glm::length(nearest);
        if (length <= radius) return true;
        double least = glm::dot(nearest, dvec2(points[0]));
        dvec2 support(points[0]);
        for (const dvec3& point : points) {
            const double along = glm::dot(nearest, dvec2(point));
            if (along < least) least = along, support = dvec2(point);
        }
        if (least > radius * length) return false;
        simplex.points[static_cast<std::size_t>(simplex.count++)] = support;
    }
    return true;
}

}  // namespace relievo::reference
