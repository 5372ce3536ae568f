// What a triangle's part of a surface lies in, told more closely than by a box: a few points whose convex hull holds it, and
// how far beyond them it may lie. From it come the boxes that rays meet, and slabs across any direction (wide_bvh.h).
//
// S is P(b) + D(b) N(b)/|N(b)|. Where D stays between low and high of a function L linear in b, P + (L + r) N is of the
// second degree in b for each r, so that it lies in the hull of its Bezier points (Farin 2002, "Curves and Surfaces for
// CAGD", section 17): three corners and three middles of edges, for r = low and for r = high. Their distance from S is that
// of |N| from one length.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "renderer/primitives.h"

namespace relievo {

// Displacement over a triangle: sum b_i corner_i + r with low <= r <= high, world units.
struct DisplacementPlane {
    std::array<double, 3> corner{};
    double low = 0, high = 0;
};

// The base triangle's.
std::array<glm::dvec3, 3> corners_of(const gpu::Primitive& primitive);
// N/|N| is N scale, but for a part of at most `off`.
struct UnitNormal {
    double scale, off;
};
UnitNormal unit_normal(const gpu::PrimitiveNormals& normals);

struct SurfaceHull {
    std::array<glm::vec3, 12> points{};  // world
    std::uint32_t count = 0;             // of points; none: the surface may lie anywhere
    float radius = 0;                    // the surface lies in the points' hull, or no further away than this
    glm::vec3 facing{};                  // the surface's mean normal, of any length and either sign; 0 where it has none
};

// Of the parallel prism between w_low and w_high, widened by the shell margin that set_shell left.
SurfaceHull prism_hull(const gpu::Primitive& primitive);
// Of S over the triangle.
SurfaceHull surface_hull(const gpu::Primitive& primitive, const gpu::PrimitiveNormals& normals,
                         const DisplacementRange& range);
SurfaceHull surface_hull(const gpu::Primitive& primitive, const gpu::PrimitiveNormals& normals,
                         const DisplacementPlane& plane);

// Of one that has points; a little larger than rounding needs.
Box box_of(const SurfaceHull& hull);
// Of the prism between w_low and w_high.
Box prism_box(const gpu::Primitive& primitive);
// Of S over the triangle for displacements in the range, after set_shell with the same.
Box surface_box(const gpu::Primitive& primitive, const gpu::PrimitiveNormals& normals, const DisplacementRange& range);
Box overlap(const Box& a, const Box& b);

struct Extent {
    double low, high;
};
// dot(x - origin, direction) of all points x where the surface may lie, and a little more than rounding needs. Without points
// without end.
Extent extent_along(const SurfaceHull& hull, const glm::dvec3& direction, const glm::dvec3& origin);

}  // namespace relievo
