// The ways to trace (DESIGN.md section 3): thin entry points over the same shader functions, with equal
// images.
#pragma once

#include <string>
#include <string_view>

namespace relievo {

namespace vulkan {
struct DeviceInfo;
}

enum class TracePath {
    automatic,  // the device's fastest: DeviceInfo::best_path
    ray_query,  // compute shaders, VK_KHR_ray_query
    pipeline,   // VK_KHR_ray_tracing_pipeline
    bvh,        // compute shaders, a tree of boxes of our own: no extension at all
};

constexpr std::string_view kTracePathNames = "ray-query, pipeline or bvh";

// From the command line's name, nothing for automatic; std::invalid_argument names --path. And back.
TracePath parse_trace_path(const std::string& name);
std::string_view trace_path_name(TracePath path);
// In words: "ray query", "ray tracing pipeline", "own BVH".
std::string_view trace_path_words(TracePath path);
// The path itself, or the device's best; std::invalid_argument where the device lacks what it takes.
TracePath resolve_trace_path(TracePath path, const vulkan::DeviceInfo& device);

}  // namespace relievo
