// Extension entry points, loaded once a device, and the check of every result.
#pragma once

#include <vulkan/vulkan.h>

namespace relievo::vulkan {

// Pointers of the device in use (the program opens one). Null where the device lacks the extension.
struct Functions {
    PFN_vkCreateAccelerationStructureKHR create_acceleration_structure = nullptr;
    PFN_vkDestroyAccelerationStructureKHR destroy_acceleration_structure = nullptr;
    PFN_vkCmdBuildAccelerationStructuresKHR cmd_build_acceleration_structures = nullptr;
    PFN_vkGetAccelerationStructureBuildSizesKHR get_build_sizes = nullptr;
    PFN_vkGetAccelerationStructureDeviceAddressKHR get_acceleration_structure_address = nullptr;
    PFN_vkCreateRayTracingPipelinesKHR create_ray_tracing_pipelines = nullptr;
    PFN_vkGetRayTracingShaderGroupHandlesKHR get_group_handles = nullptr;
    PFN_vkCmdTraceRaysKHR cmd_trace_rays = nullptr;
};
Functions& functions();
void load_functions(VkDevice device);

// Throws std::runtime_error "WHAT failed: VK_..." unless the result is VK_SUCCESS.
void check(VkResult result, const char* what);

}  // namespace relievo::vulkan
