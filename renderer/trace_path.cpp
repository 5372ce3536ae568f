// See trace_path.h.
#include "renderer/trace_path.h"

#include <stdexcept>

#include "renderer/vulkan/context.h"

namespace relievo {

namespace {

struct Way {
    TracePath path;
    std::string_view name, words;
};
constexpr Way kWays[] = {{TracePath::ray_query, "ray-query", "ray query"},
                         {TracePath::pipeline, "pipeline", "ray tracing pipeline"},
                         {TracePath::bvh, "bvh", "own BVH"}};

const Way& way(TracePath path) {
    for (const Way& w : kWays)
        if (w.path == path) return w;
    throw std::logic_error("an automatic path is resolved before it is named");
}

}  // namespace

TracePath parse_trace_path(const std::string& name) {
    if (name.empty()) return TracePath::automatic;
    for (const Way& w : kWays)
        if (w.name == name) return w.path;
    throw std::invalid_argument("--path: is \"" + name + "\", must be " + std::string(kTracePathNames));
}

std::string_view trace_path_name(TracePath path) {
    return way(path).name;
}

std::string_view trace_path_words(TracePath path) {
    return way(path).words;
}

TracePath resolve_trace_path(TracePath path, const vulkan::DeviceInfo& device) {
    if (path == TracePath::ray_query && !device.ray_query)
        throw std::invalid_argument("--path ray-query: device '" + device.name + "' has no VK_KHR_ray_query");
    if (path == TracePath::pipeline && !device.ray_pipeline)
        throw std::invalid_argument("--path pipeline: device '" + device.name +
                                    "' has no VK_KHR_ray_tracing_pipeline");
    return path == TracePath::automatic ? device.best_path : path;
}

}  // namespace relievo
