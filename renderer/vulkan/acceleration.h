// The two-level acceleration structure over the primitives' boxes: one BLAS of AABBs, one TLAS instance.
#pragma once

#include <span>

#include "renderer/vulkan/commands.h"
#include "renderer/vulkan/resources.h"

namespace relievo::vulkan {

class BoxBvh {
  public:
    BoxBvh() = default;
    // Builds over all boxes; box i answers as primitive index i. At least one box.
    BoxBvh(const Context& context, Commands& commands, std::span<const VkAabbPositionsKHR> boxes);
    ~BoxBvh();
    BoxBvh(BoxBvh&& other) noexcept { *this = std::move(other); }
    BoxBvh& operator=(BoxBvh&& other) noexcept;

    VkAabbPositionsKHR* boxes() const { return boxes_.as<VkAabbPositionsKHR>(); }  // change, then refit()
    void refit(Commands& commands);

    VkAccelerationStructureKHR top() const { return top_; }
    VkDeviceSize bytes() const;

  private:
    void build(Commands& commands, bool update);

    VkDevice device_ = VK_NULL_HANDLE;
    std::uint32_t count_ = 0;
    Buffer boxes_, bottom_storage_, top_storage_, instances_, bottom_scratch_, top_scratch_;
    VkAccelerationStructureKHR bottom_ = VK_NULL_HANDLE, top_ = VK_NULL_HANDLE;
};

}  // namespace relievo::vulkan
