// See context.h.
#include "renderer/vulkan/context.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "renderer/vulkan/functions.h"
#include "renderer/vulkan/programs.h"

namespace relievo::vulkan {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";
constexpr const char* kDriverAdvice =
    "install the package mesa-vulkan-drivers, version 24 or newer (on Debian 12 from its backports suite), to "
    "trace on the CPU";

std::atomic<int> message_count{0};

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
    ++message_count;
    std::fprintf(stderr, "validation: %s\n", data->pMessage);
    return VK_FALSE;
}

bool has_layer(const char* name) {
    std::uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    return std::any_of(layers.begin(), layers.end(),
                       [&](const VkLayerProperties& l) { return std::strcmp(l.layerName, name) == 0; });
}

bool has_instance_extension(const char* name) {
    std::uint32_t count = 0;
    vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateInstanceExtensionProperties(nullptr, &count, extensions.data());
    return std::any_of(extensions.begin(), extensions.end(),
                       [&](const VkExtensionProperties& e) { return std::strcmp(e.extensionName, name) == 0; });
}

VkDebugUtilsMessengerCreateInfoEXT messenger_info() {
    VkDebugUtilsMessengerCreateInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    info.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                           VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType =
        VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = on_message;
    return info;
}

// Five passes for each of two panes, and those of the methods before; comparing sweeps all methods.
constexpr std::size_t kProgramsOfWindow = 20, kProgramsOfRun = 64;

VkInstance make_instance(bool validation, bool for_window) {
    VkApplicationInfo app{VK_STRUCTURE_TYPE_APPLICATION_INFO, nullptr, "relievo", 1, "relievo", 1,
                          VK_API_VERSION_1_2};
    std::vector<const char*> extensions, layers;
    if (validation) {
        if (!has_layer(kValidationLayer)) {
            throw std::runtime_error("validation was asked for, but the Vulkan validation layer is missing; install "
                                     "the package vulkan-validationlayers");
        }
        layers.push_back(kValidationLayer);
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
    }
    if (for_window) {
        for (const char* name : {"VK_KHR_surface", "VK_KHR_xcb_surface", "VK_KHR_xlib_surface", "VK_KHR_wayland_surface"})
            if (has_instance_extension(name)) extensions.push_back(name);
    }
    auto messages = messenger_info();
    const VkValidationFeatureEnableEXT enabled[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT features{};
    features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
    features.pNext = &messages;
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = enabled;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pNext = validation ? &features : nullptr;
    info.pApplicationInfo = &app;
    info.enabledLayerCount = static_cast<std::uint32_t>(layers.size());
    info.ppEnabledLayerNames = layers.data();
    info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    VkInstance instance = VK_NULL_HANDLE;
    const VkResult result = vkCreateInstance(&info, nullptr, &instance);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER)
        throw std::runtime_error(std::string("no Vulkan driver was found; ") + kDriverAdvice);
    check(result, "creating the Vulkan instance");
    return instance;
}

// The loader unloads the drivers with the last instance, and NVIDIA's can be loaded into a process only 30 times (seen
// with version 580): an instance that nobody uses keeps them loaded.
void keep_drivers_loaded() { [[maybe_unused]] static const VkInstance kept = make_instance(false, false); }

std::vector<VkPhysicalDevice> physical_devices(VkInstance instance) {
    std::uint32_t count = 0;
    if (vkEnumeratePhysicalDevices(instance, &count, nullptr) != VK_SUCCESS) return {};
    std::vector<VkPhysicalDevice> devices(count);
    vkEnumeratePhysicalDevices(instance, &count, devices.data());
    devices.resize(count);
    return devices;
}

bool has_extension(const std::vector<VkExtensionProperties>& extensions, const char* name) {
    return std::any_of(extensions.begin(), extensions.end(),
                       [&](const VkExtensionProperties& e) { return std::strcmp(e.extensionName, name) == 0; });
}

std::string driver_text(const VkPhysicalDeviceDriverProperties& driver) {
    std::string text = driver.driverName;
    if (driver.driverInfo[0] != '\0') text += std::string(" ") + driver.driverInfo;
    return text;
}

// The tree of our own reads its nodes by address, two words at a time, and everything reads scalar blocks.
bool has_features(VkPhysicalDevice device) {
    VkPhysicalDeviceVulkan12Features v12{};
    v12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &v12, {}};
    vkGetPhysicalDeviceFeatures2(device, &features);
    return v12.bufferDeviceAddress == VK_TRUE && v12.scalarBlockLayout == VK_TRUE && v12.descriptorIndexing == VK_TRUE &&
           v12.shaderSampledImageArrayNonUniformIndexing == VK_TRUE && features.features.shaderInt64 == VK_TRUE;
}

// A processor that runs eight invocations side by side, which can hand words to each other.
bool walks_in_bundles(const VkPhysicalDeviceSubgroupProperties& subgroup, bool is_cpu) {
    return is_cpu && subgroup.subgroupSize == 8 && (subgroup.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT) != 0 &&
           (subgroup.supportedOperations & VK_SUBGROUP_FEATURE_SHUFFLE_BIT) != 0;
}

// Measured on lavapipe, a processor: the tree of our own takes 0.6 to 0.7 of the ray query's time, and the pipeline more.
// GPUs that offer the pipeline alone have no units for rays: on an NVIDIA H200 our tree takes 0.4 to 0.75 of its time.
TracePath best_path(const DeviceInfo& info) {
    return info.is_cpu || !info.ray_query ? TracePath::bvh : TracePath::ray_query;
}

std::string verdict(const DeviceInfo& info, bool version) {
    if (!version) return "not usable: it speaks less than Vulkan 1.2";
    if (!info.usable) return "not usable: it lacks buffer addresses, scalar blocks, indexed descriptors or 64-bit integers";
    if (info.is_cpu)
        return "usable: traces by the program's own BVH in compute shaders, the fastest way on a processor";
    if (info.ray_query) return "usable: traces by ray query in compute shaders, the fastest way on a GPU";
    return "usable: traces by the program's own BVH in compute shaders, because it has no VK_KHR_ray_query";
}

DeviceInfo describe(VkPhysicalDevice device, std::uint32_t index) {
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceSubgroupProperties subgroup{};
    subgroup.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES;
    driver.pNext = &subgroup;
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &driver, {}};
    vkGetPhysicalDeviceProperties2(device, &properties);
    std::uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
    DeviceInfo info;
    info.index = index;
    info.name = properties.properties.deviceName;
    info.driver = driver_text(driver);
    info.is_cpu = properties.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    const bool version = properties.properties.apiVersion >= VK_API_VERSION_1_2;
    const bool structures = has_extension(extensions, VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME) &&
                            has_extension(extensions, VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME);
    info.ray_query = structures && has_extension(extensions, VK_KHR_RAY_QUERY_EXTENSION_NAME);
    info.ray_pipeline = structures && has_extension(extensions, VK_KHR_RAY_TRACING_PIPELINE_EXTENSION_NAME);
    info.best_path = best_path(info);
    info.bundles = walks_in_bundles(subgroup, info.is_cpu);
    info.usable = version && has_features(device);
    info.verdict = verdict(info, version);
    return info;
}

std::uint32_t choose(const std::vector<DeviceInfo>& devices, const std::string& wanted) {
    if (!wanted.empty()) {
        for (const DeviceInfo& d : devices) {
            if (wanted != std::to_string(d.index) && d.name.find(wanted) == std::string::npos) continue;
            if (!d.usable) throw std::runtime_error("device '" + d.name + "' is " + d.verdict);
            return d.index;
        }
        std::string names;
        for (const DeviceInfo& d : devices) names += (names.empty() ? "" : ", ") + std::to_string(d.index) + " " + d.name;
        throw std::invalid_argument("--device: no device matches '" + wanted + "'; there are: " +
                                    (names.empty() ? "none" : names));
    }
    for (const bool cpu : {false, true})
        for (const DeviceInfo& d : devices)
            if (d.usable && d.is_cpu == cpu) return d.index;
    if (devices.empty()) throw std::runtime_error(std::string("no Vulkan device was found; ") + kDriverAdvice);
    throw std::runtime_error("no device is usable (" + devices.front().name + ": " + devices.front().verdict +
                             "); " + kDriverAdvice);
}

std::uint32_t compute_family(VkPhysicalDevice device) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    constexpr VkQueueFlags kBoth = VK_QUEUE_COMPUTE_BIT | VK_QUEUE_GRAPHICS_BIT;
    for (const VkQueueFlags wanted : {kBoth, VkQueueFlags{VK_QUEUE_COMPUTE_BIT}})
        for (std::uint32_t i = 0; i < count; ++i)
            if ((families[i].queueFlags & wanted) == wanted) return i;
    throw std::runtime_error("the device has no compute queue");
}

VkDevice make_device(VkPhysicalDevice physical, std::uint32_t family, const DeviceInfo& info, bool for_window) {
    std::vector<const char*> extensions;
    VkPhysicalDeviceVulkan12Features v12{};
    v12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    v12.bufferDeviceAddress = v12.scalarBlockLayout = v12.shaderSampledImageArrayNonUniformIndexing = VK_TRUE;
    v12.descriptorIndexing = VK_TRUE;
    VkPhysicalDeviceAccelerationStructureFeaturesKHR structures{};
    structures.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR;
    structures.accelerationStructure = VK_TRUE;
    VkPhysicalDeviceRayQueryFeaturesKHR query{};
    query.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR;
    query.rayQuery = VK_TRUE;
    VkPhysicalDeviceRayTracingPipelineFeaturesKHR pipeline{};
    pipeline.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_FEATURES_KHR;
    pipeline.rayTracingPipeline = VK_TRUE;
    void** tail = &structures.pNext;
    if (info.ray_query || info.ray_pipeline) {
        extensions = {VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME, VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME};
        v12.pNext = &structures;
    }
    if (info.ray_query) {
        extensions.push_back(VK_KHR_RAY_QUERY_EXTENSION_NAME);
        *tail = &query;
        tail = &query.pNext;
    }
    if (info.ray_pipeline) {
        extensions.push_back(VK_KHR_RAY_TRACING_PIPELINE_EXTENSION_NAME);
        *tail = &pipeline;
    }
    if (for_window) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, nullptr, 0, family, 1, &priority};
    VkDeviceCreateInfo create{};
    create.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    create.pNext = &v12;
    create.queueCreateInfoCount = 1;
    create.pQueueCreateInfos = &queue;
    create.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
    create.ppEnabledExtensionNames = extensions.data();
    VkPhysicalDeviceFeatures plain{};
    plain.shaderInt64 = VK_TRUE;
    create.pEnabledFeatures = &plain;
    VkDevice device = VK_NULL_HANDLE;
    check(vkCreateDevice(physical, &create, nullptr, &device), "opening the Vulkan device");
    return device;
}

bool asked_by_environment(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && value[0] != '\0' && std::strcmp(value, "0") != 0;
}

}  // namespace

std::vector<DeviceInfo> list_devices() {
    std::vector<DeviceInfo> list;
    VkInstance instance = VK_NULL_HANDLE;
    try {
        keep_drivers_loaded();
        instance = make_instance(false, false);
    } catch (const std::runtime_error&) {
        return list;  // no loader or no driver: no devices
    }
    for (VkPhysicalDevice device : physical_devices(instance))
        list.push_back(describe(device, static_cast<std::uint32_t>(list.size())));
    vkDestroyInstance(instance, nullptr);
    return list;
}

Context::Context(const ContextOptions& options) {
    const bool validation = options.validation || asked_by_environment("RELIEVO_VALIDATION");
    keep_drivers_loaded();
    instance_ = make_instance(validation, options.for_window);
    try {
        if (validation) {
            const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
                vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
            const auto messages = messenger_info();
            check(create(instance_, &messages, nullptr, &messenger_), "listening to the validation layers");
        }
        std::vector<DeviceInfo> infos;
        const auto devices = physical_devices(instance_);
        for (VkPhysicalDevice device : devices)
            infos.push_back(describe(device, static_cast<std::uint32_t>(infos.size())));
        const char* environment = std::getenv("RELIEVO_DEVICE");
        const std::string wanted =
            options.device.empty() && environment != nullptr ? environment : options.device;
        info_ = infos.empty() ? DeviceInfo{} : infos[choose(infos, wanted)];
        if (infos.empty()) choose(infos, "");
        info_.bundles = info_.bundles && options.bundles;
        physical_ = devices[info_.index];
        queue_family_ = compute_family(physical_);
        device_ = make_device(physical_, queue_family_, info_, options.for_window);
    } catch (...) {
        release();
        throw;
    }
    vkGetDeviceQueue(device_, queue_family_, 0, &queue_);
    load_functions(device_);
    programs_ = std::make_unique<Programs>(options.for_window ? kProgramsOfWindow : kProgramsOfRun);
}

Context::~Context() { release(); }

void Context::release() {
    programs_.reset();
    if (device_ != VK_NULL_HANDLE) vkDestroyDevice(device_, nullptr);
    if (messenger_ != VK_NULL_HANDLE) {
        const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
        destroy(instance_, messenger_, nullptr);
    }
    if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
}

VkResult Context::wait_idle() const {
    const auto held = hold_queue();
    return vkDeviceWaitIdle(device_);
}

int Context::validation_messages() { return message_count; }

}  // namespace relievo::vulkan
