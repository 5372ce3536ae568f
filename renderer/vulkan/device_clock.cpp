// See device_clock.h.
#include "renderer/vulkan/device_clock.h"

#include <array>

#include "renderer/vulkan/functions.h"

namespace relievo::vulkan {

DeviceClock::DeviceClock(const Context& context) : context_(&context) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(context.physical_device(), &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(context.physical_device(), &count, families.data());
    const std::uint32_t bits = families.at(context.queue_family()).timestampValidBits;
    if (bits == 0) return;
    valid_bits_ = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(context.physical_device(), &properties);
    ms_per_tick_ = static_cast<double>(properties.limits.timestampPeriod) * 1e-6;
    VkQueryPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = 2;
    VkQueryPool pool = VK_NULL_HANDLE;
    check(vkCreateQueryPool(context.device(), &info, nullptr, &pool), "creating a query pool");
    pool_ = {context.device(), pool};
}

void DeviceClock::begin(VkCommandBuffer commands) {
    if (!pool_) return;
    vkCmdResetQueryPool(commands, pool_.get(), 0, 2);
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, pool_.get(), 0);
}

void DeviceClock::end(VkCommandBuffer commands) {
    if (!pool_) return;
    vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, pool_.get(), 1);
    written_ = true;
}

double DeviceClock::last_ms() const {
    if (!written_) return 0;
    std::array<std::uint64_t, 2> ticks{};
    check(vkGetQueryPoolResults(context_->device(), pool_.get(), 0, 2, sizeof ticks, ticks.data(),
                                sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
          "reading timestamps");
    return static_cast<double>((ticks[1] - ticks[0]) & valid_bits_) * ms_per_tick_;
}

}  // namespace relievo::vulkan
