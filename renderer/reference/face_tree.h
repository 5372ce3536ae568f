// A bounding volume hierarchy over boxes in double, asked by rays nearest first.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

namespace relievo::reference {

struct Bounds {
    glm::dvec3 low{1e300}, high{-1e300};

    void include(const Bounds& other);
};

class FaceTree {
  public:
    FaceTree() = default;
    explicit FaceTree(std::vector<Bounds> boxes);

    // Calls visit(index of the box, z where the ray meets it) for the boxes that the ray meets between z_min
    // and `z_max`, which visit may lower; nearer branches first. Unit direction.
    template <typename Visit>
    void visit(const glm::dvec3& origin, const glm::dvec3& direction, double z_min, const double& z_max,
               Visit&& visit) const {
        if (nodes_.empty()) return;
        std::vector<Entry> stack;
        push(stack, 0, origin, direction, z_min, z_max);
        while (!stack.empty()) {
            const Entry entry = stack.back();
            stack.pop_back();
            if (entry.z > z_max) continue;
            const Node& node = nodes_[entry.node];
            if (node.box != kInner) {
                visit(node.box, entry.z);
                continue;
            }
            const std::size_t before = stack.size();
            push(stack, node.left, origin, direction, z_min, z_max);
            push(stack, node.right, origin, direction, z_min, z_max);
            if (stack.size() == before + 2 && stack[before].z < stack[before + 1].z)
                std::swap(stack[before], stack[before + 1]);
        }
    }

  private:
    static constexpr std::uint32_t kInner = 0xffffffff;
    struct Node {
        Bounds bounds;
        std::uint32_t left = 0, right = 0;
        std::uint32_t box = kInner;
    };
    struct Entry {
        std::uint32_t node;
        double z;
    };
    std::uint32_t build(const std::vector<Bounds>& boxes, std::vector<std::uint32_t>& order,
                        std::size_t first, std::size_t count);
    // Pushes the node if the ray meets its bounds.
    void push(std::vector<Entry>& stack, std::uint32_t node, const glm::dvec3& origin,
              const glm::dvec3& direction, double z_min, double z_max) const;

    std::vector<Node> nodes_;
};

}  // namespace relievo::reference
