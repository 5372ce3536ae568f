// The two-level acceleration structure that rays meet: one BLAS of boxes or of triangles, one TLAS instance.
#pragma once

#include "renderer/vulkan/commands.h"
#include "renderer/vulkan/resources.h"

namespace relievo::vulkan {

// What buffers of boxes, vertices and corners are made with, beside their other usage.
constexpr VkBufferUsageFlags kBuildInput =
    VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR;

// What a BLAS holds: `count` boxes or triangles, at least one. The i-th answers as primitive index i.
struct Geometry {
    VkAccelerationStructureGeometryKHR description{};
    std::uint32_t count = 0;
};

// VkAabbPositionsKHR, one after the other.
Geometry box_geometry(VkDeviceAddress boxes, std::uint32_t count);

// Triangles as the device reads them.
struct TriangleBuffers {
    VkDeviceAddress vertices;  // each begins with its position, three floats; a multiple of 4
    std::uint32_t vertex_count;
    VkDeviceSize vertex_stride;  // bytes, a multiple of 4
    VkDeviceAddress corners;  // three 32-bit vertex numbers a triangle, one after the other; a multiple of 4
    std::uint32_t triangle_count;
};
Geometry triangle_geometry(const TriangleBuffers& buffers);

class AccelerationStructure {
  public:
    AccelerationStructure() = default;
    // Builds. The geometry's buffers outlive it: refit() reads them again.
    AccelerationStructure(const Context& context, Commands& commands, const Geometry& geometry);
    ~AccelerationStructure();
    AccelerationStructure(AccelerationStructure&& other) noexcept { *this = std::move(other); }
    AccelerationStructure& operator=(AccelerationStructure&& other) noexcept;

    // After boxes or vertices have moved; corners stay as they were.
    void refit(Commands& commands);

    VkAccelerationStructureKHR top() const { return top_; }
    VkDeviceSize bytes() const;  // without the geometry's buffers

  private:
    void build(Commands& commands, bool update);

    VkDevice device_ = VK_NULL_HANDLE;
    Geometry geometry_;
    Buffer bottom_storage_, top_storage_, instances_, bottom_scratch_, top_scratch_;
    VkAccelerationStructureKHR bottom_ = VK_NULL_HANDLE, top_ = VK_NULL_HANDLE;
};

}  // namespace relievo::vulkan
