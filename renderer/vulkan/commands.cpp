// See commands.h.
#include "renderer/vulkan/commands.h"

#include "renderer/vulkan/functions.h"

namespace relievo::vulkan {

Commands::Commands(const Context& context) : context_(&context) {
    VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr,
                                 VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT, context.queue_family()};
    VkCommandPool pool_handle = VK_NULL_HANDLE;
    check(vkCreateCommandPool(context.device(), &pool, nullptr, &pool_handle), "creating a command pool");
    pool_ = {context.device(), pool_handle};
    VkCommandBufferAllocateInfo info{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr, pool_handle,
                                     VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
    check(vkAllocateCommandBuffers(context.device(), &info, &buffer_), "allocating a command buffer");
    VkFenceCreateInfo fence{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO, nullptr, 0};
    VkFence fence_handle = VK_NULL_HANDLE;
    check(vkCreateFence(context.device(), &fence, nullptr, &fence_handle), "creating a fence");
    fence_ = {context.device(), fence_handle};
}

void Commands::run(const std::function<void(VkCommandBuffer)>& record) {
    VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO, nullptr,
                                   VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT, nullptr};
    check(vkBeginCommandBuffer(buffer_, &begin), "beginning a command buffer");
    record(buffer_);
    check(vkEndCommandBuffer(buffer_), "ending a command buffer");
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &buffer_;
    const VkFence fence = fence_.get();
    {
        const auto held = context_->hold_queue();
        check(vkQueueSubmit(context_->queue(), 1, &submit, fence), "submitting work");
    }
    check(vkWaitForFences(context_->device(), 1, &fence, VK_TRUE, UINT64_MAX), "waiting for the device");
    check(vkResetFences(context_->device(), 1, &fence), "resetting a fence");
}

}  // namespace relievo::vulkan
