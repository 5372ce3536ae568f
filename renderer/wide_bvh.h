// The tree of boxes that shaders/trace/bundle.glsl and bvh.glsl walk: four children a node, their boxes in bytes
// (gpu::BvhNode), after Ylitie, Karras and Laine 2017. Boxes that change are refitted: the tree's shape
// stays, as in a driver's own update.
//
// A small triangle of a smooth map is a thin tile, and where it lies aslant, a box says little of it. So nodes
// near the leaves bound their children along a fourth direction too, across the surface that they hold: a slab,
// as of k-DOPs (Klosowski and others 1998), but with a direction for each node, the nearest of a fixed set
// (as oriented boxes have rotations in Kern and others 2025, "DOBB-BVH").
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/box_bvh_builder.h"
#include "renderer/primitives.h"
#include "renderer/surface_hull.h"
#include "shaders/shared.h"

namespace relievo {

class WideBvh {
  public:
    WideBvh() = default;
    // Box i is the leaf gpu::kBvhLeaf | i, and hull i lies in it. At least one box; as many hulls, or none.
    explicit WideBvh(std::span<const Box> boxes, std::span<const SurfaceHull> hulls = {});

    std::span<const gpu::BvhNode> nodes() const { return nodes_; }
    void set_box(std::uint32_t i, const Box& box);
    void set_hull(std::uint32_t i, const SurfaceHull& hull);  // with set_box; there are hulls
    // Makes the nodes true again after set_box(), and says which ones changed: the ancestors of the boxes
    // set, as far up as they have slabs or their boxes changed. What it costs does not depend on the number of boxes.
    std::vector<std::uint32_t> refit();

    // The most children that a walk may have waiting; never above gpu::kBvhStack (box_bvh_builder.h).
    std::uint32_t deepest_stack() const;
    std::uint64_t bytes() const;  // on the processor

  private:
    bool fit(std::uint32_t node);  // whether the node's own box changed
    void fit_slab(std::uint32_t node, gpu::BvhNode& to) const;
    bool has_slab(std::uint32_t node) const;
    void collect_leaves(std::uint32_t child, std::vector<std::uint32_t>& leaves) const;

    std::vector<BvhBranch> branches_;
    std::vector<Box> boxes_, node_boxes_;
    std::vector<SurfaceHull> hulls_;
    std::vector<std::uint32_t> branch_of_;   // of each box
    std::vector<std::uint32_t> leaf_count_;  // of each branch, below it
    std::vector<std::uint32_t> touched_;    // branches of boxes set since the last refit
    std::vector<gpu::BvhNode> nodes_;
};

}  // namespace relievo
