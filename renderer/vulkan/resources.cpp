// See resources.h.
#include "renderer/vulkan/resources.h"

#include <algorithm>
#include <stdexcept>

#include "renderer/vulkan/functions.h"

namespace relievo::vulkan {
namespace {

std::uint32_t memory_type(const Context& context, std::uint32_t allowed, VkMemoryPropertyFlags wanted,
                          VkMemoryPropertyFlags required) {
    VkPhysicalDeviceMemoryProperties properties;
    vkGetPhysicalDeviceMemoryProperties(context.physical_device(), &properties);
    for (VkMemoryPropertyFlags flags : {wanted | required, required}) {
        for (std::uint32_t i = 0; i < properties.memoryTypeCount; ++i) {
            if ((allowed >> i & 1u) != 0 && (properties.memoryTypes[i].propertyFlags & flags) == flags) return i;
        }
    }
    throw std::runtime_error("the device has no memory of the kind needed");
}

MemoryHandle allocate(const Context& context, const VkMemoryRequirements& needs, Access access, bool addressable) {
    constexpr VkMemoryPropertyFlags kHost =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    VkMemoryAllocateFlagsInfo flags{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO, nullptr,
                                    VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT, 0};
    VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, addressable ? &flags : nullptr, needs.size, 0};
    info.memoryTypeIndex = memory_type(
        context, needs.memoryTypeBits,
        access == Access::read_back ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT,
        access == Access::device ? 0 : kHost);
    VkDeviceMemory memory = VK_NULL_HANDLE;
    check(vkAllocateMemory(context.device(), &info, nullptr, &memory), "allocating device memory");
    return {context.device(), memory};
}

}  // namespace

Buffer::Buffer(const Context& context, VkDeviceSize bytes, VkBufferUsageFlags usage, Access access)
    : bytes_(std::max<VkDeviceSize>(bytes, 64)) {
    usage |= VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = bytes_;
    info.usage = usage;
    VkBuffer buffer = VK_NULL_HANDLE;
    check(vkCreateBuffer(context.device(), &info, nullptr, &buffer), "creating a buffer");
    buffer_ = {context.device(), buffer};
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(context.device(), buffer, &needs);
    memory_ = allocate(context, needs, access, true);
    check(vkBindBufferMemory(context.device(), buffer, memory_.get(), 0), "binding buffer memory");
    VkBufferDeviceAddressInfo address{VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO, nullptr, buffer};
    address_ = vkGetBufferDeviceAddress(context.device(), &address);
    if (access != Access::device) {
        check(vkMapMemory(context.device(), memory_.get(), 0, VK_WHOLE_SIZE, 0, &mapped_), "mapping a buffer");
    }
}

Image::Image(const Context& context, int width, int height, VkFormat format, VkImageUsageFlags usage, int mips)
    : width_(width), height_(height), mips_(mips) {
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 1};
    info.mipLevels = static_cast<std::uint32_t>(mips);
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = usage;
    VkImage image = VK_NULL_HANDLE;
    check(vkCreateImage(context.device(), &info, nullptr, &image), "creating an image");
    image_ = {context.device(), image};
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(context.device(), image, &needs);
    bytes_ = needs.size;
    memory_ = allocate(context, needs, Access::device, false);
    check(vkBindImageMemory(context.device(), image, memory_.get(), 0), "binding image memory");
    VkImageViewCreateInfo view{};
    view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view.image = image;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = format;
    view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, static_cast<std::uint32_t>(mips), 0, 1};
    VkImageView handle = VK_NULL_HANDLE;
    check(vkCreateImageView(context.device(), &view, nullptr, &handle), "creating an image view");
    view_ = {context.device(), handle};
}

void Image::transition(VkCommandBuffer commands, VkImageLayout from, VkImageLayout to) const {
    VkImageMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image_.get();
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, static_cast<std::uint32_t>(mips_), 0, 1};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0,
                         nullptr, 0, nullptr, 1, &barrier);
}

void memory_barrier(VkCommandBuffer commands) {
    VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr,
                            VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT,
                            VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 1,
                         &barrier, 0, nullptr, 0, nullptr);
}

SamplerHandle make_sampler(const Context& context, bool clamp, bool linear) {
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = info.minFilter = linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    info.maxLod = VK_LOD_CLAMP_NONE;
    const VkSamplerAddressMode mode =
        clamp ? VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE : VK_SAMPLER_ADDRESS_MODE_REPEAT;
    info.addressModeU = info.addressModeV = info.addressModeW = mode;
    VkSampler sampler = VK_NULL_HANDLE;
    check(vkCreateSampler(context.device(), &info, nullptr, &sampler), "creating a sampler");
    return {context.device(), sampler};
}

}  // namespace relievo::vulkan
