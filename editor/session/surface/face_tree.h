// A bounding volume hierarchy over the base triangles, for the faces near a point. It is built once: the
// displacement only widens a query's radius, so strokes and a change of the amplitude leave it as it is.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "renderer/scene/mesh.h"

namespace relievo {

class FaceTree {
  public:
    explicit FaceTree(const Mesh& mesh);

    // Appends every face whose base triangle's box is at most `radius` from `centre`, and maybe a few others.
    void near(glm::vec3 centre, float radius, std::vector<std::uint32_t>& faces) const;

  private:
    struct Node {
        glm::vec3 low, high;
        std::uint32_t first, count;  // of order_ in a leaf; count 0: children at this node + 1 and at first
    };
    void build(const Mesh& mesh, std::uint32_t first, std::uint32_t last);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

}  // namespace relievo
