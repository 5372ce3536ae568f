// See bindings.h.
#include "renderer/bindings.h"

#include <array>
#include <vector>

#include "renderer/vulkan/functions.h"
#include "shaders/shared.h"

namespace relievo {
namespace {

struct Binding {
    std::uint32_t index;
    VkDescriptorType type;
};
constexpr std::array kBindings{
    Binding{gpu::kBindTlas, VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR},
    Binding{gpu::kBindFrame, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},
    Binding{gpu::kBindPrimitives, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
    Binding{gpu::kBindNormals, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
    Binding{gpu::kBindObjects, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
    Binding{gpu::kBindAccumulation, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
    Binding{gpu::kBindCounts, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
    Binding{gpu::kBindDisplay, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE},
    Binding{gpu::kBindAov, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
    Binding{gpu::kBindPickRays, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
    Binding{gpu::kBindPickResults, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
    Binding{gpu::kBindMaps, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
    Binding{gpu::kBindOpacity, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
    Binding{gpu::kBindPyramids, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
    Binding{gpu::kBindSlabs, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
    Binding{gpu::kBindRayCounts, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
    Binding{gpu::kBindNotes, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
    Binding{gpu::kBindProcedural, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
    Binding{gpu::kBindAlbedo, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
};
static_assert(kBindings.size() == gpu::kBindCount);

std::uint32_t descriptor_count(const Binding& b, std::size_t objects) {
    return b.type == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER ? static_cast<std::uint32_t>(objects) : 1u;
}

// Our own tree is read by address: there is no acceleration structure, and perhaps no extension that knows one.
bool used(const Binding& b, TracePath path) { return b.index != gpu::kBindTlas || path != TracePath::bvh; }

}  // namespace

vulkan::SetLayoutHandle make_set_layout(const vulkan::Context& context, std::size_t objects, TracePath path) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const Binding& b : kBindings)
        if (used(b, path)) bindings.push_back({b.index, b.type, descriptor_count(b, objects), VK_SHADER_STAGE_ALL, nullptr});
    VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, nullptr, 0,
                                         static_cast<std::uint32_t>(bindings.size()), bindings.data()};
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    vulkan::check(vkCreateDescriptorSetLayout(context.device(), &info, nullptr, &layout),
                  "creating a descriptor set layout");
    return {context.device(), layout};
}

vulkan::DescriptorPoolHandle make_pool(const vulkan::Context& context, std::size_t objects, TracePath path) {
    std::vector<VkDescriptorPoolSize> sizes;
    for (const Binding& b : kBindings)
        if (used(b, path)) sizes.push_back({b.type, descriptor_count(b, objects)});
    VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, nullptr, 0, 1,
                                    static_cast<std::uint32_t>(sizes.size()), sizes.data()};
    VkDescriptorPool pool = VK_NULL_HANDLE;
    vulkan::check(vkCreateDescriptorPool(context.device(), &info, nullptr, &pool), "creating a descriptor pool");
    return {context.device(), pool};
}

}  // namespace relievo
