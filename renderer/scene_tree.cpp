// See scene_tree.h.
#include "renderer/scene_tree.h"

#include <algorithm>

namespace relievo {
namespace {

VkAabbPositionsKHR vulkan_box(const Box& b) {
    return {b.low.x, b.low.y, b.low.z, b.high.x, b.high.y, b.high.z};
}

}  // namespace

SceneTree::SceneTree(const vulkan::Context& context, vulkan::Commands& commands, std::span<const Box> boxes,
                     std::span<const SurfaceHull> hulls, TracePath path) {
    if (path == TracePath::bvh) {
        wide_.emplace(boxes, hulls);
        const auto nodes = wide_->nodes();
        nodes_ = vulkan::Buffer(context, nodes.size_bytes(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                vulkan::Access::host);
        std::ranges::copy(nodes, nodes_.as<gpu::BvhNode>());
        return;
    }
    boxes_ = vulkan::Buffer(context, boxes.size() * sizeof(VkAabbPositionsKHR), vulkan::kBuildInput,
                            vulkan::Access::host);
    std::ranges::transform(boxes, boxes_.as<VkAabbPositionsKHR>(), vulkan_box);
    structure_ = vulkan::AccelerationStructure(
        context, commands, vulkan::box_geometry(boxes_.address(), static_cast<std::uint32_t>(boxes.size())));
}

SceneTree::SceneTree(const vulkan::Context& context, vulkan::Commands& commands,
                     const vulkan::TriangleBuffers& triangles)
    : structure_(context, commands, vulkan::triangle_geometry(triangles)) {}

void SceneTree::set_box(std::uint32_t primitive, const Box& box) {
    if (wide_)
        wide_->set_box(primitive, box);
    else
        boxes_.as<VkAabbPositionsKHR>()[primitive] = vulkan_box(box);
}

void SceneTree::set_hull(std::uint32_t primitive, const SurfaceHull& hull) {
    if (wide_) wide_->set_hull(primitive, hull);
}

void SceneTree::refit(vulkan::Commands& commands) {
    if (!wide_) return structure_.refit(commands);
    // Nothing runs on the device between calls (vulkan::Commands waits), so its nodes may be written.
    for (const std::uint32_t node : wide_->refit()) nodes_.as<gpu::BvhNode>()[node] = wide_->nodes()[node];
}

}  // namespace relievo
