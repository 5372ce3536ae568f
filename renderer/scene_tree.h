// What rays find primitives by: the device's acceleration structure over boxes or triangles, or a tree of
// boxes of our own in a buffer.
#pragma once

#include <optional>
#include <span>

#include "renderer/surface_hull.h"
#include "renderer/trace_path.h"
#include "renderer/vulkan/acceleration.h"
#include "renderer/wide_bvh.h"

namespace relievo {

class SceneTree {
  public:
    SceneTree() = default;
    // Box i is primitive i. At least one. Hulls may be none; only our own tree makes use of them.
    SceneTree(const vulkan::Context& context, vulkan::Commands& commands, std::span<const Box> boxes,
              std::span<const SurfaceHull> hulls, TracePath path);
    // The device's, over triangles that it meets by itself; triangle i is primitive i. Their buffers outlive
    // the tree.
    SceneTree(const vulkan::Context& context, vulkan::Commands& commands,
              const vulkan::TriangleBuffers& triangles);

    // After boxes were set, or the triangles' vertices have moved: refit().
    bool has_boxes() const { return wide_ || boxes_.bytes() > 0; }
    void set_box(std::uint32_t primitive, const Box& box);
    void set_hull(std::uint32_t primitive, const SurfaceHull& hull);  // where the tree was made of hulls, too
    void refit(vulkan::Commands& commands);

    // One of the two: nothing of the other is there.
    VkAccelerationStructureKHR acceleration_structure() const { return structure_.top(); }
    VkDeviceAddress nodes() const { return wide_ ? nodes_.address() : 0; }
    VkDeviceSize bytes() const { return wide_ ? nodes_.bytes() : boxes_.bytes() + structure_.bytes(); }

  private:
    vulkan::Buffer boxes_;  // of the device's structure
    vulkan::AccelerationStructure structure_;
    std::optional<WideBvh> wide_;
    vulkan::Buffer nodes_;
};

}  // namespace relievo
