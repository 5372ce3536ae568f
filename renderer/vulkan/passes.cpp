// See passes.h.
#include "renderer/vulkan/passes.h"

#include <string>

#include "renderer/vulkan/functions.h"

namespace relievo::vulkan {
namespace {

constexpr std::array<std::string_view, kPassCount> kComputeFiles{"beauty.comp", "aov.comp", "pick.comp", "aov.comp",
                                                              "pick.comp"};
constexpr std::array<std::string_view, kPassCount> kBvhFiles{"beauty_bvh.comp", "aov_bvh.comp", "pick_bvh.comp",
                                                             "aov_bvh.comp", "pick_bvh.comp"};
// What a ray costs and does is asked of it alone: in a bundle the order of boxes depends on the rays beside it.
constexpr std::array<std::string_view, kPassCount> kBundleFiles{"beauty_bundle.comp", "aov_bundle.comp", "pick_bundle.comp",
                                                                "aov_bvh.comp", "pick_bvh.comp"};
constexpr std::array<std::string_view, kPassCount> kRayFiles{"beauty.rgen", "aov.rgen", "pick.rgen", "aov.rgen", "pick.rgen"};

}  // namespace

Passes::Passes(const Context& context, VkDescriptorSetLayout set_layout, std::string_view method, TracePath path,
               bool driver_triangles, bool bundles, const SpecConstants& constants)
    : context_(&context), method_(method), path_(path), driver_triangles_(driver_triangles), bundles_(bundles),
      constants_(constants) {
    const VkPushConstantRange range{VK_SHADER_STAGE_ALL, 0, sizeof(gpu::PushData)};
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1;
    info.pSetLayouts = &set_layout;
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &range;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    check(vkCreatePipelineLayout(context.device(), &info, nullptr, &layout), "creating a pipeline layout");
    layout_ = {context.device(), layout};
}

SpecConstants Passes::constants_of(Pass pass) const {
    SpecConstants constants = constants_;
    constants[gpu::kSpecNotes] = pass == Pass::counts  ? gpu::kNotesCounts
                                 : pass == Pass::notes ? gpu::kNotesLog
                                                       : gpu::kNotesNone;
    return constants;
}

const Program& Passes::program(Pass pass) {
    const auto index = static_cast<std::size_t>(pass);
    if (!programs_[index]) {
        const auto& files = path_ == TracePath::pipeline    ? kRayFiles
                            : path_ == TracePath::ray_query ? kComputeFiles
                            : bundles_                      ? kBundleFiles
                                                            : kBvhFiles;
        const ProgramKey key{std::string(method_), std::string(files[index]), path_, driver_triangles_,
                             constants_of(pass)};
        programs_[index] = context_->programs().get(*context_, layout_.get(), key);
    }
    return *programs_[index];
}

void Passes::record(VkCommandBuffer commands, Pass pass, VkDescriptorSet set, const gpu::PushData& push, int width,
                    int height) {
    const Program& program = this->program(pass);
    const bool by_pipeline = path_ == TracePath::pipeline;
    const VkPipelineBindPoint point =
        by_pipeline ? VK_PIPELINE_BIND_POINT_RAY_TRACING_KHR : VK_PIPELINE_BIND_POINT_COMPUTE;
    vkCmdBindPipeline(commands, point, program.pipeline.get());
    vkCmdBindDescriptorSets(commands, point, layout_.get(), 0, 1, &set, 0, nullptr);
    vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_ALL, 0, sizeof(push), &push);
    const auto w = static_cast<std::uint32_t>(width), h = static_cast<std::uint32_t>(height);
    if (by_pipeline) {
        const VkStridedDeviceAddressRegionKHR callable{};
        functions().cmd_trace_rays(commands, &program.generation, &program.miss, &program.hit, &callable, w, h, 1);
    } else if (pass == Pass::pick || pass == Pass::notes) {
        vkCmdDispatch(commands, (w + 63) / 64, 1, 1);
    } else {
        vkCmdDispatch(commands, (w + gpu::kGroupWidth - 1) / gpu::kGroupWidth,
                      (h + gpu::kGroupWidth - 1) / gpu::kGroupWidth, 1);
    }
}

}  // namespace relievo::vulkan
