// See acceleration.h.
#include "renderer/vulkan/acceleration.h"

#include <cstring>
#include <utility>

#include "renderer/vulkan/functions.h"

namespace relievo::vulkan {
namespace {

constexpr VkBufferUsageFlags kStorage = VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR;
constexpr VkBufferUsageFlags kScratch = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
constexpr VkDeviceSize kScratchAlignment = 256;  // no device asks for more

VkAccelerationStructureGeometryKHR geometry_of(VkGeometryTypeKHR type) {
    VkAccelerationStructureGeometryKHR geometry{};
    geometry.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR;
    geometry.geometryType = type;
    return geometry;
}

VkAccelerationStructureGeometryKHR instance_geometry(VkDeviceAddress instances) {
    auto geometry = geometry_of(VK_GEOMETRY_TYPE_INSTANCES_KHR);
    geometry.geometry.instances.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR;
    geometry.geometry.instances.data.deviceAddress = instances;
    return geometry;
}

VkAccelerationStructureBuildGeometryInfoKHR build_info(VkAccelerationStructureTypeKHR type,
                                                       const VkAccelerationStructureGeometryKHR& geometry) {
    VkAccelerationStructureBuildGeometryInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR;
    info.type = type;
    info.flags = VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR |
                 VK_BUILD_ACCELERATION_STRUCTURE_ALLOW_UPDATE_BIT_KHR;
    info.geometryCount = 1;
    info.pGeometries = &geometry;
    return info;
}

VkAccelerationStructureKHR create(const Context& context, VkAccelerationStructureBuildGeometryInfoKHR info,
                                  std::uint32_t count, Buffer& storage, Buffer& scratch) {
    VkAccelerationStructureBuildSizesInfoKHR sizes{};
    sizes.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR;
    functions().get_build_sizes(context.device(), VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR, &info, &count,
                                &sizes);
    storage = Buffer(context, sizes.accelerationStructureSize, kStorage, Access::device);
    scratch = Buffer(context, std::max(sizes.buildScratchSize, sizes.updateScratchSize) + kScratchAlignment,
                     kScratch, Access::device);
    VkAccelerationStructureCreateInfoKHR create_info{};
    create_info.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR;
    create_info.buffer = storage.get();
    create_info.size = sizes.accelerationStructureSize;
    create_info.type = info.type;
    VkAccelerationStructureKHR result = VK_NULL_HANDLE;
    check(functions().create_acceleration_structure(context.device(), &create_info, nullptr, &result),
          "creating an acceleration structure");
    return result;
}

VkDeviceAddress aligned(VkDeviceAddress address) {
    return (address + kScratchAlignment - 1) / kScratchAlignment * kScratchAlignment;
}

}  // namespace

Geometry box_geometry(VkDeviceAddress boxes, std::uint32_t count) {
    auto geometry = geometry_of(VK_GEOMETRY_TYPE_AABBS_KHR);
    geometry.geometry.aabbs.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_AABBS_DATA_KHR;
    geometry.geometry.aabbs.data.deviceAddress = boxes;
    geometry.geometry.aabbs.stride = sizeof(VkAabbPositionsKHR);
    return {geometry, count};
}

// Every device that builds takes this format of positions.
Geometry triangle_geometry(const TriangleBuffers& buffers) {
    auto geometry = geometry_of(VK_GEOMETRY_TYPE_TRIANGLES_KHR);
    auto& triangles = geometry.geometry.triangles;
    triangles.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR;
    triangles.vertexFormat = VK_FORMAT_R32G32B32_SFLOAT;
    triangles.vertexData.deviceAddress = buffers.vertices;
    triangles.vertexStride = buffers.vertex_stride;
    triangles.maxVertex = buffers.vertex_count - 1;
    triangles.indexType = VK_INDEX_TYPE_UINT32;
    triangles.indexData.deviceAddress = buffers.corners;
    return {geometry, buffers.triangle_count};
}

AccelerationStructure::AccelerationStructure(const Context& context, Commands& commands, const Geometry& geometry)
    : device_(context.device()), geometry_(geometry) {
    bottom_ = create(context, build_info(VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR, geometry_.description),
                     geometry_.count, bottom_storage_, bottom_scratch_);
    VkAccelerationStructureDeviceAddressInfoKHR address{
        VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR, nullptr, bottom_};
    VkAccelerationStructureInstanceKHR instance{};
    instance.transform.matrix[0][0] = instance.transform.matrix[1][1] = instance.transform.matrix[2][2] = 1.0f;
    instance.mask = 0xff;
    instance.accelerationStructureReference = functions().get_acceleration_structure_address(device_, &address);
    instances_ = Buffer(context, sizeof(instance), kBuildInput, Access::host);
    std::memcpy(instances_.mapped(), &instance, sizeof(instance));
    const auto top_geometry = instance_geometry(instances_.address());
    top_ = create(context, build_info(VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR, top_geometry), 1, top_storage_,
                  top_scratch_);
    build(commands, false);
}

AccelerationStructure::~AccelerationStructure() {
    if (top_ != VK_NULL_HANDLE) functions().destroy_acceleration_structure(device_, top_, nullptr);
    if (bottom_ != VK_NULL_HANDLE) functions().destroy_acceleration_structure(device_, bottom_, nullptr);
}

AccelerationStructure& AccelerationStructure::operator=(AccelerationStructure&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(geometry_, other.geometry_);
    std::swap(bottom_storage_, other.bottom_storage_);
    std::swap(top_storage_, other.top_storage_);
    std::swap(instances_, other.instances_);
    std::swap(bottom_scratch_, other.bottom_scratch_);
    std::swap(top_scratch_, other.top_scratch_);
    std::swap(bottom_, other.bottom_);
    std::swap(top_, other.top_);
    return *this;
}

void AccelerationStructure::refit(Commands& commands) { build(commands, true); }

void AccelerationStructure::build(Commands& commands, bool update) {
    const auto top_geometry = instance_geometry(instances_.address());
    auto bottom = build_info(VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR, geometry_.description);
    auto top = build_info(VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR, top_geometry);
    bottom.mode = top.mode = update ? VK_BUILD_ACCELERATION_STRUCTURE_MODE_UPDATE_KHR
                                    : VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR;
    bottom.srcAccelerationStructure = update ? bottom_ : VK_NULL_HANDLE;
    top.srcAccelerationStructure = update ? top_ : VK_NULL_HANDLE;
    bottom.dstAccelerationStructure = bottom_;
    top.dstAccelerationStructure = top_;
    bottom.scratchData.deviceAddress = aligned(bottom_scratch_.address());
    top.scratchData.deviceAddress = aligned(top_scratch_.address());
    const VkAccelerationStructureBuildRangeInfoKHR bottom_range{geometry_.count, 0, 0, 0}, top_range{1, 0, 0, 0};
    const VkAccelerationStructureBuildRangeInfoKHR *bottom_ranges = &bottom_range, *top_ranges = &top_range;
    commands.run([&](VkCommandBuffer cmd) {
        memory_barrier(cmd);
        functions().cmd_build_acceleration_structures(cmd, 1, &bottom, &bottom_ranges);
        memory_barrier(cmd);
        functions().cmd_build_acceleration_structures(cmd, 1, &top, &top_ranges);
        memory_barrier(cmd);
    });
}

VkDeviceSize AccelerationStructure::bytes() const {
    return bottom_storage_.bytes() + top_storage_.bytes() + instances_.bytes() +
           bottom_scratch_.bytes() + top_scratch_.bytes();
}

}  // namespace relievo::vulkan
