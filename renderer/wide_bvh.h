// The tree of boxes that shaders/trace/bundle.glsl and bvh.glsl walk: four children a node, their boxes in bytes
// (gpu::BvhNode), after Ylitie, Karras and Laine 2017. Boxes that change are refitted: the tree's shape
// stays, as in a driver's own update.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/box_bvh_builder.h"
#include "renderer/primitives.h"
#include "shaders/shared.h"

namespace relievo {

class WideBvh {
  public:
    WideBvh() = default;
    // Box i is the leaf gpu::kBvhLeaf | i. At least one box.
    explicit WideBvh(std::span<const Box> boxes);

    std::span<const gpu::BvhNode> nodes() const { return nodes_; }
    void set_box(std::uint32_t i, const Box& box);
    // Makes the nodes true again after set_box(), and says which ones changed: the ancestors of the boxes
    // set, as far up as their boxes changed. What it costs does not depend on the number of boxes.
    std::vector<std::uint32_t> refit();

    // The most children that a walk may have waiting; never above gpu::kBvhStack (box_bvh_builder.h).
    std::uint32_t deepest_stack() const;
    std::uint64_t bytes() const;  // on the processor

  private:
    bool fit(std::uint32_t node);  // whether the node's own box changed

    std::vector<BvhBranch> branches_;
    std::vector<Box> boxes_, node_boxes_;
    std::vector<std::uint32_t> branch_of_;  // of each box
    std::vector<std::uint32_t> touched_;    // branches of boxes set since the last refit
    std::vector<gpu::BvhNode> nodes_;
};

}  // namespace relievo
