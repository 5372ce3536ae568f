#include "editor/session/surface/uv_borders.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "renderer/scene/mesh_topology.h"

namespace relievo {
namespace {

// A face that folds onto one of its edges would make its neighbours' common edge look like one of four faces.
bool folded(const Mesh::Face& face) {
    const auto& p = face.position;
    return p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
}

UvSide side(const Mesh& mesh, const MapGrid& grid, const MeshEdge& edge, EdgeSide at) {
    const Mesh::Face& face = mesh.faces[at.face];
    const std::uint32_t i = at.corner;
    UvSide s{at.face, grid.texel_from_uv(mesh.uvs[face.uv[i]]),
             grid.texel_from_uv(mesh.uvs[face.uv[(i + 1) % 3]]),
             grid.texel_from_uv(mesh.uvs[face.uv[(i + 2) % 3]])};
    if (face.position[i] != edge.p0) std::swap(s.from, s.to);
    return s;
}

// The same texels on both sides: equal, or under repeat a whole number of maps apart.
bool same_place(const UvSide& a, const UvSide& b, const MapGrid& grid) {
    const auto none = [&](double distance, int size) {
        return std::abs(grid.wrap == Wrap::repeat ? std::remainder(distance, size) : distance) < kTexelSlack;
    };
    const glm::dvec2 from = a.from - b.from, to = a.to - b.to;
    const bool moved_as_one = glm::length(from - to) < kTexelSlack;
    return moved_as_one && none(from.x, grid.width) && none(from.y, grid.height);
}

struct Axis {
    glm::length_t index = 0;  // 0: along a row, 1: along a column
    double length = 0;        // signed, texels
    double inside = 0;        // across the edge, the sign of the island's inside
};

// index of the axis that the side runs along; length 0 where it runs along none or has no inside.
Axis axis_of(const UvSide& s) {
    const glm::dvec2 d = s.to - s.from;
    Axis axis;
    if (std::abs(d.x) < kTexelSlack) axis.index = 1;
    const double across = d[1 - axis.index];
    const double inside = s.inner[1 - axis.index] - s.from[1 - axis.index];
    if (std::abs(across) >= kTexelSlack || std::abs(inside) < kTexelSlack) return axis;
    axis.length = d[axis.index];
    axis.inside = inside > 0 ? 1 : -1;
    return axis;
}

// The isometry before its translation is rounded to whole texels.
struct Placement {
    TexelIsometry turn;  // tx = ty = 0
    glm::dvec2 shift;
};

Placement place(const UvSeam& seam) {
    const Axis a = axis_of(seam.a), b = axis_of(seam.b);
    const std::int64_t along = (a.length > 0) == (b.length > 0) ? 1 : -1,
                       flip = a.inside == b.inside ? -1 : 1;
    Placement p{};
    if (a.index == b.index) {
        p.turn.xx = a.index == 0 ? along : flip;
        p.turn.yy = a.index == 0 ? flip : along;
    } else {
        p.turn.yx = a.index == 0 ? along : flip;
        p.turn.xy = a.index == 0 ? flip : along;
    }
    const glm::dvec2 from(snapped(seam.a.from.x), snapped(seam.a.from.y));
    p.shift = glm::dvec2(snapped(seam.b.from.x), snapped(seam.b.from.y)) -
              glm::dvec2(static_cast<double>(p.turn.xx) * from.x + static_cast<double>(p.turn.xy) * from.y,
                         static_cast<double>(p.turn.yx) * from.x + static_cast<double>(p.turn.yy) * from.y);
    return p;
}

bool is_aligned(const UvSeam& seam) {
    const Axis a = axis_of(seam.a), b = axis_of(seam.b);
    if (std::abs(a.length) < kTexelSlack || std::abs(b.length) < kTexelSlack) return false;
    if (std::abs(std::abs(a.length) - std::abs(b.length)) >= kTexelSlack) return false;
    const glm::dvec2 shift = place(seam).shift;
    return std::abs(shift.x - std::round(shift.x)) < kTexelSlack &&
           std::abs(shift.y - std::round(shift.y)) < kTexelSlack;
}

}  // namespace

double UvSide::length() const {
    return glm::length(to - from);
}

double snapped(double texel_coordinate) {
    const double grid = std::round(texel_coordinate * 256) / 256;
    return std::abs(grid - texel_coordinate) < kTexelSlack / 2 ? grid : texel_coordinate;
}

TexelIsometry across(const UvSeam& seam) {
    Placement p = place(seam);
    p.turn.tx = std::llround(p.shift.x);
    p.turn.ty = std::llround(p.shift.y);
    return p.turn;
}

UvBorders find_uv_borders(const Mesh& mesh, const MapGrid& grid) {
    UvBorders borders;
    const MeshTopology topology = find_edges(mesh);
    std::vector<UvSide> sides;
    for (const MeshEdge& edge : topology.edges) {
        sides.clear();
        for (const EdgeSide at : topology.sides_of(edge)) {
            if (!folded(mesh.faces[at.face])) sides.push_back(side(mesh, grid, edge, at));
        }
        if (sides.size() != 2) {
            borders.open.insert(borders.open.end(), sides.begin(), sides.end());
            continue;
        }
        UvSeam seam{{edge.p0, edge.p1}, sides[0], sides[1], false};
        if (same_place(seam.a, seam.b, grid)) continue;
        seam.aligned = is_aligned(seam);
        borders.seams.push_back(seam);
    }
    return borders;
}

}  // namespace relievo
