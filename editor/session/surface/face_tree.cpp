#include "editor/session/surface/face_tree.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <numeric>

namespace relievo {
namespace {

constexpr std::uint32_t kLeafFaces = 4;

glm::vec3 corner(const Mesh& mesh, std::uint32_t face, std::size_t i) {
    return mesh.positions[mesh.faces[face].position[i]];
}

}  // namespace

FaceTree::FaceTree(const Mesh& mesh) : order_(mesh.faces.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!order_.empty()) build(mesh, 0, static_cast<std::uint32_t>(order_.size()));
}

void FaceTree::build(const Mesh& mesh, std::uint32_t first, std::uint32_t last) {
    Node node{glm::vec3(std::numeric_limits<float>::infinity()),
              glm::vec3(-std::numeric_limits<float>::infinity()), first, last - first};
    for (std::uint32_t i = first; i < last; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 p = corner(mesh, order_[i], k);
            node.low = glm::min(node.low, p);
            node.high = glm::max(node.high, p);
        }
    }
    const auto at = nodes_.size();
    nodes_.push_back(node);
    if (last - first <= kLeafFaces) return;

    const glm::vec3 extent = node.high - node.low;
    const glm::length_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                               : extent.y >= extent.z                       ? 1
                                                                            : 2;
    const auto key = [&](std::uint32_t face) {
        return corner(mesh, face, 0)[axis] + corner(mesh, face, 1)[axis] + corner(mesh, face, 2)[axis];
    };
    const std::uint32_t middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    build(mesh, first, middle);
    nodes_[at].count = 0;
    nodes_[at].first = static_cast<std::uint32_t>(nodes_.size());
    build(mesh, middle, last);
}

void FaceTree::near(glm::vec3 centre, float radius, std::vector<std::uint32_t>& faces) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, 64> stack;  // the halving split keeps the depth under 32
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const std::uint32_t at = stack[--depth];
        const Node& node = nodes_[at];
        const glm::vec3 away = glm::max(glm::max(node.low - centre, centre - node.high), glm::vec3(0));
        if (glm::dot(away, away) > radius * radius) continue;
        if (node.count == 0) {
            stack[depth++] = node.first;
            stack[depth++] = at + 1;
        } else {
            faces.insert(faces.end(), order_.begin() + node.first, order_.begin() + node.first + node.count);
        }
    }
}

}  // namespace relievo
