// The device's own clock around a piece of recorded work.
#pragma once

#include "renderer/vulkan/context.h"
#include "renderer/vulkan/handle.h"

namespace relievo::vulkan {

class DeviceClock {
  public:
    // Works on every device; one whose queue has no timestamps answers 0.
    explicit DeviceClock(const Context& context);

    void begin(VkCommandBuffer commands);
    void end(VkCommandBuffer commands);
    // Milliseconds between the last begin and end, once the device has done them; 0 without timestamps.
    double last_ms() const;

  private:
    const Context* context_;
    QueryPoolHandle pool_;  // none without timestamps
    double ms_per_tick_ = 0;
    std::uint64_t valid_bits_ = 0;  // mask of a tick's bits
    bool written_ = false;
};

}  // namespace relievo::vulkan
