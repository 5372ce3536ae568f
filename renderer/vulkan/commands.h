// Recording and submitting, one batch at a time: every call waits for the device.
#pragma once

#include <functional>

#include "renderer/vulkan/context.h"
#include "renderer/vulkan/handle.h"

namespace relievo::vulkan {

class Commands {
  public:
    explicit Commands(const Context& context);

    // Records what `record` asks for, submits it and waits until the device is done.
    void run(const std::function<void(VkCommandBuffer)>& record);

  private:
    const Context* context_;
    CommandPoolHandle pool_;
    FenceHandle fence_;
    VkCommandBuffer buffer_ = VK_NULL_HANDLE;
};

}  // namespace relievo::vulkan
