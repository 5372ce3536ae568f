// Instance, device and queue: which device is used, by which way of tracing, and why.
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "renderer/trace_path.h"

namespace relievo::vulkan {

struct DeviceInfo {
    std::uint32_t index = 0;
    std::string name, driver;
    bool is_cpu = false;
    bool ray_query = false, ray_pipeline = false;
    TracePath best_path = TracePath::bvh;  // what automatic means
    bool bundles = false;  // TracePath::bvh can walk by bundles of eight rays (shaders/trace/bundle.glsl), else ray by ray
    bool usable = false;
    std::string verdict;  // why it is usable and which path it takes, or what it lacks
};

struct ContextOptions {
    std::string device;       // index or part of a name; empty: RELIEVO_DEVICE, else the best (GPU before CPU)
    bool validation = false;  // also on with RELIEVO_VALIDATION=1; messages are counted, printed to stderr
    bool for_window = false;  // surface and swapchain extensions
    bool bundles = true;      // false: rays walk the tree alone, as on a device that cannot do otherwise
};

// Never throws for want of a device: an empty list is an answer.
std::vector<DeviceInfo> list_devices();

class Programs;

class Context {
  public:
    // Throws std::runtime_error with one sentence that names the package to install when there is no Vulkan, no
    // device, or none that is usable.
    explicit Context(const ContextOptions& options);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    VkInstance instance() const { return instance_; }
    VkPhysicalDevice physical_device() const { return physical_; }
    VkDevice device() const { return device_; }
    VkQueue queue() const { return queue_; }
    // Vulkan lets one thread at a time give a queue work, or wait until the device is idle: who does holds this.
    std::unique_lock<std::mutex> hold_queue() const { return std::unique_lock(queue_held_); }
    VkResult wait_idle() const;
    std::uint32_t queue_family() const { return queue_family_; }
    const DeviceInfo& info() const { return info_; }
    Programs& programs() const { return *programs_; }  // compiled for this device

    // Messages of the validation layers so far; 0 without validation. Tests fail on any.
    static int validation_messages();

  private:
    void release();

    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    mutable std::mutex queue_held_;
    std::uint32_t queue_family_ = 0;
    DeviceInfo info_;
    std::unique_ptr<Programs> programs_;
};

}  // namespace relievo::vulkan
