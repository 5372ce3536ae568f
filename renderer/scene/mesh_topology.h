// Edges of a mesh with the faces on them, by welded positions; texture seams do not count.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/scene/mesh.h"

namespace relievo {

// A face's edge from its `corner` to the next one.
struct EdgeSide {
    std::uint32_t face;
    std::uint32_t corner;  // 0 to 2
};

struct MeshEdge {
    std::uint32_t p0, p1;  // positions, p0 < p1
    std::uint32_t first_side, side_count;
    bool opposed;  // two sides that run against each other: neighbours of one orientation

    bool is_border() const { return side_count == 1; }
    bool is_manifold() const { return side_count == 2 && opposed; }
};

struct MeshTopology {
    std::vector<MeshEdge> edges;  // by p0, then p1; a face that names a position twice has no edge there
    std::vector<EdgeSide> sides;  // edge by edge, ascending faces
    std::vector<std::uint32_t> face_edges;  // 3 * face + corner: the edge that starts there, or kNoEdge

    static constexpr std::uint32_t kNoEdge = ~0u;
    std::span<const EdgeSide> sides_of(const MeshEdge& edge) const {
        return {sides.data() + edge.first_side, edge.side_count};
    }
};

MeshTopology find_edges(const Mesh& mesh);

}  // namespace relievo
