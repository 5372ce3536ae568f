// One base triangle in double: P, N and texel coordinates as linear functions of the barycentrics, S with its
// derivatives in one texel cell, and bounds of S's second derivatives over a part of the triangle.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "renderer/scene/mesh.h"

namespace relievo::reference {

// A place of the triangle: barycentrics of vertices 1 and 2, and the texel coordinates there.
struct DomainPoint {
    glm::dvec2 b, texel;
};

// D over one texel cell, in world units: d00 + x dx + y dy + x y dxy, (x, y) = texel - corner.
struct CellPatch {
    glm::dvec2 corner;
    double d00, dx, dy, dxy;

    double at(const glm::dvec2& texel) const;
    glm::dvec2 gradient(const glm::dvec2& texel) const;  // per texel
};

// S and its derivatives by b1 and b2.
struct SurfaceJet {
    glm::dvec3 s, s1, s2;
};

// Over a triangle with edges e1 and e2 from its first corner: bounds of |d2S/de1de1|, |d2S/de1de2|,
// |d2S/de2de2|.
struct Curvature {
    double m11, m12, m22;

    // How far S leaves the flat triangle through its corners. With c the barycentrics of a place, the
    // expansion of S around it gives at most 1/2 sum_i c_i (a_i^2 m11 + 2 |a_i b_i| m12 + b_i^2 m22), and
    // sum_i c_i a_i^2 = c_1 (1 - c_1) <= 1/4, likewise the others.
    double sag() const { return (m11 + 2 * m12 + m22) / 8; }
    // How far a derivative along e1 (e2) leaves the difference of the corners.
    double turn1() const { return m11 + m12; }
    double turn2() const { return m12 + m22; }
};

// Bounds of the length of N over the convex hull of some points. `low` is 0 where N may vanish.
struct LengthRange {
    double low, high;
};

struct FaceShape {
    glm::dvec3 p, p1, p2;  // P = p + b1 p1 + b2 p2
    glm::dvec3 n, n1, n2;
    glm::dvec2 texel, texel1, texel2;
    std::uint32_t object, face;

    glm::dvec3 base(const glm::dvec2& b) const { return p + p1 * b.x + p2 * b.y; }
    glm::dvec3 normal(const glm::dvec2& b) const { return n + n1 * b.x + n2 * b.y; }
    glm::dvec2 texel_at(const glm::dvec2& b) const { return texel + texel1 * b.x + texel2 * b.y; }

    // Requires N != 0 there.
    glm::dvec3 position(const CellPatch& patch, const DomainPoint& at) const;
    SurfaceJet jet(const CellPatch& patch, const DomainPoint& at) const;
    LengthRange normal_length(std::span<const DomainPoint> points) const;
    // Requires that N does not vanish on the triangle: `shortest_normal` > 0.
    Curvature curvature(const CellPatch& patch, const std::array<DomainPoint, 3>& corners,
                        double shortest_normal) const;
};

// How texture coordinates become texels: uv * scale + shift.
struct TexelFrame {
    glm::dvec2 scale, shift;
};

FaceShape make_face_shape(const Mesh& mesh, std::uint32_t object, std::uint32_t face, const TexelFrame& frame);

}  // namespace relievo::reference
