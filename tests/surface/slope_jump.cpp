#include "slope_jump.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "editor/session/surface/texel_triangle.h"
#include "editor/session/surface/uv_borders.h"
#include "renderer/scene/mesh_topology.h"

namespace relievo::test {
namespace {

struct Side {
    glm::dvec2 from, to;  // in texels
    // The slope away from the edge, in the triangle's plane, of a gradient in texels.
    glm::dvec2 across;
};

class Jumps {
  public:
    Jumps(const Mesh& mesh, const HeightMap& map, const Displacement& displacement)
        : mesh_(mesh),
          map_(map),
          grid_{map.width(), map.height(), displacement.wrap},
          unit_(displacement.amplitude / 65535) {}

    const MapGrid& grid() const { return grid_; }

    SlopeJump of(const UvSeam& seam, bool is_seam) const {
        SlopeJump jump{{seam.position[0], seam.position[1]}, is_seam, seam.aligned, 0, 0};
        const Side a = side(seam.a, seam), b = side(seam.b, seam);
        const int count = std::max(1, static_cast<int>(8 * std::max(seam.a.length(), seam.b.length())));
        // The ends belong to other edges too.
        for (int i = 1; i < count; ++i) {
            const double t = static_cast<double>(i) / count;
            const double difference = std::abs(slope(a, t) + slope(b, t));
            jump.greatest = std::max(jump.greatest, difference);
            jump.mean += difference / count;
        }
        return jump;
    }

  private:
    Side side(const UvSide& s, const UvSeam& seam) const {
        const TexelTriangle triangle = texel_triangle(mesh_, s.face, grid_);
        const auto& f = mesh_.faces[s.face].position;
        const glm::dvec3 p0(mesh_.positions[f[0]]);
        const glm::dvec3 e1 = glm::dvec3(mesh_.positions[f[1]]) - p0,
                         e2 = glm::dvec3(mesh_.positions[f[2]]) - p0;
        const glm::dvec3 along =
            glm::dvec3(mesh_.positions[seam.position[1]]) - glm::dvec3(mesh_.positions[seam.position[0]]);
        const glm::dvec3 middle = p0 + (e1 + e2) / 3.0 - glm::dvec3(mesh_.positions[seam.position[0]]);
        const glm::dvec3 away =
            -glm::normalize(middle - along * (glm::dot(middle, along) / glm::dot(along, along)));
        // Barycentrics of the unit step, then texels.
        const double e11 = glm::dot(e1, e1), e12 = glm::dot(e1, e2), e22 = glm::dot(e2, e2);
        const double d1 = glm::dot(away, e1), d2 = glm::dot(away, e2), det = e11 * e22 - e12 * e12;
        return {s.from, s.to,
                ((d1 * e22 - d2 * e12) / det) * (triangle.p[1] - triangle.p[0]) +
                    ((d2 * e11 - d1 * e12) / det) * (triangle.p[2] - triangle.p[0])};
    }

    double slope(const Side& side, double t) const {
        const glm::dvec2 p = side.from + (side.to - side.from) * t;
        const auto at = [&](double x, double y) {
            return bilinear(map_.texels(), bilinear_taps(grid_, p + glm::dvec2(x, y)));
        };
        return unit_ *
               (side.across.x * (at(0.5, 0) - at(-0.5, 0)) + side.across.y * (at(0, 0.5) - at(0, -0.5)));
    }

    const Mesh& mesh_;
    const HeightMap& map_;
    MapGrid grid_;
    double unit_;
};

}  // namespace

std::vector<SlopeJump> slope_jumps(const Mesh& mesh, const HeightMap& map, const Displacement& displacement) {
    const Jumps jumps(mesh, map, displacement);
    std::vector<SlopeJump> all;
    const UvBorders borders = find_uv_borders(mesh, jumps.grid());
    for (const UvSeam& seam : borders.seams) all.push_back(jumps.of(seam, true));

    const MeshTopology topology = find_edges(mesh);
    for (const MeshEdge& edge : topology.edges) {
        const auto sides = topology.sides_of(edge);
        const bool is_seam = std::any_of(borders.seams.begin(), borders.seams.end(), [&](const UvSeam& s) {
            return s.position[0] == edge.p0 && s.position[1] == edge.p1;
        });
        if (is_seam || sides.size() != 2) continue;
        UvSeam within{{edge.p0, edge.p1}, {}, {}, false};
        UvSide* side = &within.a;
        for (const EdgeSide at : sides) {
            const auto& face = mesh.faces[at.face];
            side->face = at.face;
            side->from = jumps.grid().texel_from_uv(mesh.uvs[face.uv[at.corner]]);
            side->to = jumps.grid().texel_from_uv(mesh.uvs[face.uv[(at.corner + 1) % 3]]);
            if (face.position[at.corner] != edge.p0) std::swap(side->from, side->to);
            side = &within.b;
        }
        all.push_back(jumps.of(within, false));
    }
    return all;
}

}  // namespace relievo::test
