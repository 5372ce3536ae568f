// See functions.h.
#include "renderer/vulkan/functions.h"

#include <stdexcept>
#include <string>

namespace relievo::vulkan {
namespace {

template <typename Pointer>
void load(VkDevice device, Pointer& pointer, const char* name) {
    pointer = reinterpret_cast<Pointer>(vkGetDeviceProcAddr(device, name));
}

std::string result_name(VkResult result) {
    switch (result) {
        case VK_ERROR_OUT_OF_HOST_MEMORY: return "out of host memory";
        case VK_ERROR_OUT_OF_DEVICE_MEMORY: return "out of device memory";
        case VK_ERROR_INITIALIZATION_FAILED: return "initialization failed";
        case VK_ERROR_DEVICE_LOST: return "device lost";
        case VK_ERROR_LAYER_NOT_PRESENT: return "layer not present";
        case VK_ERROR_EXTENSION_NOT_PRESENT: return "extension not present";
        case VK_ERROR_FEATURE_NOT_PRESENT: return "feature not present";
        case VK_ERROR_INCOMPATIBLE_DRIVER: return "incompatible driver";
        case VK_ERROR_SURFACE_LOST_KHR: return "surface lost";
        default: return "VkResult " + std::to_string(static_cast<int>(result));
    }
}

}  // namespace

Functions& functions() {
    static Functions table;
    return table;
}

void load_functions(VkDevice device) {
    Functions& f = functions();
    load(device, f.create_acceleration_structure, "vkCreateAccelerationStructureKHR");
    load(device, f.destroy_acceleration_structure, "vkDestroyAccelerationStructureKHR");
    load(device, f.cmd_build_acceleration_structures, "vkCmdBuildAccelerationStructuresKHR");
    load(device, f.get_build_sizes, "vkGetAccelerationStructureBuildSizesKHR");
    load(device, f.get_acceleration_structure_address, "vkGetAccelerationStructureDeviceAddressKHR");
    load(device, f.create_ray_tracing_pipelines, "vkCreateRayTracingPipelinesKHR");
    load(device, f.get_group_handles, "vkGetRayTracingShaderGroupHandlesKHR");
    load(device, f.cmd_trace_rays, "vkCmdTraceRaysKHR");
}

void check(VkResult result, const char* what) {
    if (result != VK_SUCCESS) throw std::runtime_error(std::string(what) + " failed: " + result_name(result));
}

}  // namespace relievo::vulkan
