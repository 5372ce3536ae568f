// Buffers and images with their memory. Buffers that the host sees stay mapped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

#include "renderer/vulkan/context.h"
#include "renderer/vulkan/handle.h"

namespace relievo::vulkan {

enum class Access {
    // Mapped and coherent; on the device too where it offers that (all of a CPU's memory, resizable BAR). Only to be
    // written: of a GPU's own memory the processor reads some bytes a microsecond.
    host,
    read_back,  // mapped, coherent and cached: the device writes, the processor reads
    device,     // device only
};

class Buffer {
  public:
    Buffer() = default;
    // `bytes` may be 0: a small buffer is made, since descriptors need one. Throws std::runtime_error.
    Buffer(const Context& context, VkDeviceSize bytes, VkBufferUsageFlags usage, Access access);

    VkBuffer get() const { return buffer_.get(); }
    VkDeviceSize bytes() const { return bytes_; }
    VkDeviceAddress address() const { return address_; }
    void* mapped() const { return mapped_; }
    template <typename T>
    T* as() const { return static_cast<T*>(mapped_); }

  private:
    MemoryHandle memory_;  // declared first, freed last
    BufferHandle buffer_;
    VkDeviceSize bytes_ = 0;
    VkDeviceAddress address_ = 0;
    void* mapped_ = nullptr;
};

class Image {
  public:
    Image() = default;
    Image(const Context& context, int width, int height, VkFormat format, VkImageUsageFlags usage, int mips = 1);

    VkImage get() const { return image_.get(); }
    VkImageView view() const { return view_.get(); }
    int width() const { return width_; }
    int height() const { return height_; }
    VkDeviceSize bytes() const { return bytes_; }
    int mips() const { return mips_; }

    // Records a transition of the whole image, all mips, with full memory dependencies between the stages.
    void transition(VkCommandBuffer commands, VkImageLayout from, VkImageLayout to) const;

  private:
    MemoryHandle memory_;
    ImageHandle image_;
    ImageViewHandle view_;
    int width_ = 0, height_ = 0, mips_ = 1;
    VkDeviceSize bytes_ = 0;
};

// A device address as shaders take it, low word first.
inline glm::uvec2 address_words(VkDeviceAddress a) {
    return {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(a >> 32)};
}

// Everything written before is visible to everything after: one barrier, used between passes.
void memory_barrier(VkCommandBuffer commands);

// Wrap by repeat or clamp; nearest or linear filter.
SamplerHandle make_sampler(const Context& context, bool clamp, bool linear);

}  // namespace relievo::vulkan
