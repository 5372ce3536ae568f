// The primitives' boxes as rays find them: the device's acceleration structure, or a tree of our own in a
// buffer.
#pragma once

#include <optional>
#include <span>

#include "renderer/trace_path.h"
#include "renderer/vulkan/acceleration.h"
#include "renderer/wide_bvh.h"

namespace relievo {

class BoxTree {
  public:
    BoxTree() = default;
    // Box i is primitive i. At least one.
    BoxTree(const vulkan::Context& context, vulkan::Commands& commands, std::span<const Box> boxes,
            TracePath path);

    void set_box(std::uint32_t primitive, const Box& box);  // then refit()
    void refit(vulkan::Commands& commands);

    // One of the two: nothing of the other is there.
    VkAccelerationStructureKHR acceleration_structure() const { return structure_.top(); }
    VkDeviceAddress nodes() const { return wide_ ? nodes_.address() : 0; }
    VkDeviceSize bytes() const { return wide_ ? nodes_.bytes() : structure_.bytes(); }

  private:
    vulkan::BoxBvh structure_;
    std::optional<WideBvh> wide_;
    vulkan::Buffer nodes_;
};

}  // namespace relievo
