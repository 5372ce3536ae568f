// Edges by sorting the sides of all faces.
#include "renderer/scene/mesh_topology.h"

#include <algorithm>
#include <tuple>

namespace relievo {

MeshTopology find_edges(const Mesh& mesh) {
    struct Side {
        std::uint32_t low, high, face, corner;
        bool forward;
    };
    std::vector<Side> all;
    all.reserve(3 * mesh.faces.size());
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const auto& p = mesh.faces[face].position;
            const std::uint32_t from = p[corner], to = p[(corner + 1) % 3];
            if (from != to) all.push_back({std::min(from, to), std::max(from, to), face, corner, from < to});
        }
    }
    std::sort(all.begin(), all.end(), [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.face, a.corner) < std::tie(b.low, b.high, b.face, b.corner);
    });

    MeshTopology topology;
    topology.sides.reserve(all.size());
    topology.face_edges.assign(3 * mesh.faces.size(), MeshTopology::kNoEdge);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Side& side = all[i];
        if (i == 0 || side.low != all[i - 1].low || side.high != all[i - 1].high) {
            topology.edges.push_back({side.low, side.high, static_cast<std::uint32_t>(i), 0, false});
        }
        MeshEdge& edge = topology.edges.back();
        edge.opposed = edge.side_count == 1 && side.forward != all[i - 1].forward;
        ++edge.side_count;
        topology.sides.push_back({side.face, side.corner});
        topology.face_edges[3 * side.face + side.corner] =
            static_cast<std::uint32_t>(topology.edges.size() - 1);
    }
    return topology;
}

}  // namespace relievo
