// See face_shape.h.
#include "renderer/reference/face_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace relievo::reference {

using glm::dvec2;
using glm::dvec3;

double CellPatch::at(const dvec2& texel) const {
    const dvec2 f = texel - corner;
    return d00 + f.x * dx + f.y * (dy + f.x * dxy);
}

dvec2 CellPatch::gradient(const dvec2& texel) const {
    const dvec2 f = texel - corner;
    return {dx + f.y * dxy, dy + f.x * dxy};
}

dvec3 FaceShape::position(const CellPatch& patch, const DomainPoint& at) const {
    return base(at.b) + glm::normalize(normal(at.b)) * patch.at(at.texel);
}

SurfaceJet FaceShape::jet(const CellPatch& patch, const DomainPoint& at) const {
    const dvec3 big_n = normal(at.b);
    const double length = glm::length(big_n);
    const dvec3 unit = big_n / length;
    const double d = patch.at(at.texel);
    const dvec2 gradient = patch.gradient(at.texel);
    const auto derivative = [&](const dvec3& along, const dvec3& turn, const dvec2& step) {
        return along + (turn - unit * glm::dot(unit, turn)) * (d / length) + unit * glm::dot(gradient, step);
    };
    return {base(at.b) + unit * d, derivative(p1, n1, texel1), derivative(p2, n2, texel2)};
}

LengthRange FaceShape::normal_length(std::span<const DomainPoint> points) const {
    dvec3 mean(0);
    double longest = 0;
    for (const DomainPoint& point : points) {
        const dvec3 at = normal(point.b);
        mean += at;
        longest = std::max(longest, glm::length(at));
    }
    mean /= static_cast<double>(points.size());
    double reach = 0;
    for (const DomainPoint& point : points) reach = std::max(reach, glm::length(normal(point.b) - mean));
    return {std::max(glm::length(mean) - reach, 0.0), longest};
}

// S = P + D n with n = N/|N| and P linear, so S'' = D'' n + 2 D' n' + D n''. For N linear, with p and q the
// parts of a direction's change of N across and along n, and l = |N|:
//   n' = p/l,   |n''|^2 = p^2 (4 q^2 + p^2)/l^4 <= 4/3 |N'|^4/l^4,
// and a symmetric form that is bounded by C |u|^2 on the diagonal is bounded by C |u| |v| off it.
Curvature FaceShape::curvature(const CellPatch& patch, const std::array<DomainPoint, 3>& corners,
                               double shortest_normal) const {
    const dvec2 e1 = corners[1].b - corners[0].b, e2 = corners[2].b - corners[0].b;
    const double turn1 = glm::length(n1 * e1.x + n2 * e1.y) / shortest_normal;
    const double turn2 = glm::length(n1 * e2.x + n2 * e2.y) / shortest_normal;
    const dvec2 t1 = texel1 * e1.x + texel2 * e1.y, t2 = texel1 * e2.x + texel2 * e2.y;
    const double d11 = std::abs(2 * patch.dxy * t1.x * t1.y), d22 = std::abs(2 * patch.dxy * t2.x * t2.y);
    const double d12 = std::abs(patch.dxy * (t1.x * t2.y + t2.x * t1.y));
    // D' is linear, so the corners bound it; D leaves the plane of its corners by at most its own sag.
    double d = 0, d1 = 0, d2 = 0;
    for (const DomainPoint& corner : corners) {
        const dvec2 gradient = patch.gradient(corner.texel);
        d = std::max(d, std::abs(patch.at(corner.texel)));
        d1 = std::max(d1, std::abs(glm::dot(gradient, t1)));
        d2 = std::max(d2, std::abs(glm::dot(gradient, t2)));
    }
    d += (d11 + 2 * d12 + d22) / 8;
    constexpr double kTurn = 1.1547005383792517;  // sqrt(4/3)
    return {d11 + 2 * d1 * turn1 + kTurn * d * turn1 * turn1,
            d12 + d1 * turn2 + d2 * turn1 + kTurn * d * turn1 * turn2,
            d22 + 2 * d2 * turn2 + kTurn * d * turn2 * turn2};
}

FaceShape make_face_shape(const Mesh& mesh, std::uint32_t object, std::uint32_t face, const TexelFrame& frame) {
    const Mesh::Face& f = mesh.faces[face];
    std::array<dvec3, 3> position, normal;
    std::array<dvec2, 3> texel;
    for (std::size_t i = 0; i < 3; ++i) {
        position[i] = mesh.positions[f.position[i]];
        normal[i] = mesh.normals[f.position[i]];
        texel[i] = dvec2(mesh.uvs[f.uv[i]]) * frame.scale + frame.shift;
    }
    return {position[0],
            position[1] - position[0],
            position[2] - position[0],
            normal[0],
            normal[1] - normal[0],
            normal[2] - normal[0],
            texel[0],
            texel[1] - texel[0],
            texel[2] - texel[0],
            object,
            face};
}

}  // namespace relievo::reference
