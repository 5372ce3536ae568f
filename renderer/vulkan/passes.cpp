// See passes.h.
#include "renderer/vulkan/passes.h"

#include <cstring>
#include <stdexcept>
#include <string>

#include "renderer/vulkan/functions.h"

namespace relievo::vulkan {
namespace {

constexpr std::array<std::string_view, kPassCount> kComputeFiles{"beauty.comp", "aov.comp", "pick.comp", "aov.comp",
                                                              "pick.comp"};
constexpr std::array<std::string_view, kPassCount> kBvhFiles{"beauty_bvh.comp", "aov_bvh.comp", "pick_bvh.comp",
                                                             "aov_bvh.comp", "pick_bvh.comp"};
constexpr std::array<std::string_view, kPassCount> kRayFiles{"beauty.rgen", "aov.rgen", "pick.rgen", "aov.rgen", "pick.rgen"};

struct Specialisation {
    std::array<VkSpecializationMapEntry, gpu::kSpecCount> entries{};
    VkSpecializationInfo info{};
    explicit Specialisation(const SpecConstants& constants) {  // kept by reference
        for (std::uint32_t i = 0; i < gpu::kSpecCount; ++i)
            entries[i] = {i, i * std::uint32_t{sizeof(std::uint32_t)}, sizeof(std::uint32_t)};
        info = {gpu::kSpecCount, entries.data(), sizeof(SpecConstants), constants.data()};
    }
};

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits flag, VkShaderModule module,
                                      const Specialisation& specialisation) {
    VkPipelineShaderStageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage = flag;
    info.module = module;
    info.pName = "main";
    info.pSpecializationInfo = &specialisation.info;
    return info;
}

std::uint32_t round_up(std::uint32_t value, std::uint32_t step) { return (value + step - 1) / step * step; }

}  // namespace

Passes::Passes(const Context& context, VkDescriptorSetLayout set_layout, std::string_view method, TracePath path,
               const SpecConstants& constants)
    : context_(&context), method_(method), path_(path), constants_(constants) {
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

ShaderHandle Passes::module(std::string_view file) const {
    const auto code = shader_code(method_, file);
    if (code.empty()) throw std::runtime_error("no shader '" + std::string(file) + "' in this build");
    VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, nullptr, 0, code.size_bytes(),
                                  code.data()};
    VkShaderModule shader = VK_NULL_HANDLE;
    check(vkCreateShaderModule(context_->device(), &info, nullptr, &shader), "creating a shader module");
    return {context_->device(), shader};
}

SpecConstants Passes::constants_of(Pass pass) const {
    SpecConstants constants = constants_;
    constants[gpu::kSpecNotes] = pass == Pass::counts  ? gpu::kNotesCounts
                                 : pass == Pass::notes ? gpu::kNotesLog
                                                       : gpu::kNotesNone;
    return constants;
}

void Passes::make_compute(Program& program, Pass pass) {
    const auto& files = path_ == TracePath::bvh ? kBvhFiles : kComputeFiles;
    const ShaderHandle shader = module(files[static_cast<std::size_t>(pass)]);
    const SpecConstants constants = constants_of(pass);
    const Specialisation specialisation(constants);
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage = stage(VK_SHADER_STAGE_COMPUTE_BIT, shader.get(), specialisation);
    info.layout = layout_.get();
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(context_->device(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          "creating a compute pipeline");
    program.pipeline = {context_->device(), pipeline};
}

void Passes::make_rays(Program& program, Pass pass) {
    const ShaderHandle generation = module(kRayFiles[static_cast<std::size_t>(pass)]), miss = module("miss.rmiss"), intersection = module("hit.rint"),
                       closest = module("hit.rchit");
    const SpecConstants constants = constants_of(pass);
    const Specialisation specialisation(constants);
    const std::array<VkPipelineShaderStageCreateInfo, 4> stages{
        stage(VK_SHADER_STAGE_RAYGEN_BIT_KHR, generation.get(), specialisation),
        stage(VK_SHADER_STAGE_MISS_BIT_KHR, miss.get(), specialisation),
        stage(VK_SHADER_STAGE_INTERSECTION_BIT_KHR, intersection.get(), specialisation),
        stage(VK_SHADER_STAGE_CLOSEST_HIT_BIT_KHR, closest.get(), specialisation)};
    std::array<VkRayTracingShaderGroupCreateInfoKHR, 3> groups{};
    for (std::uint32_t i = 0; i < groups.size(); ++i) {
        groups[i].sType = VK_STRUCTURE_TYPE_RAY_TRACING_SHADER_GROUP_CREATE_INFO_KHR;
        groups[i].type = i < 2 ? VK_RAY_TRACING_SHADER_GROUP_TYPE_GENERAL_KHR
                               : VK_RAY_TRACING_SHADER_GROUP_TYPE_PROCEDURAL_HIT_GROUP_KHR;
        groups[i].generalShader = i < 2 ? i : VK_SHADER_UNUSED_KHR;
        groups[i].closestHitShader = i < 2 ? VK_SHADER_UNUSED_KHR : 3;
        groups[i].anyHitShader = VK_SHADER_UNUSED_KHR;
        groups[i].intersectionShader = i < 2 ? VK_SHADER_UNUSED_KHR : 2;
    }
    VkRayTracingPipelineCreateInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_RAY_TRACING_PIPELINE_CREATE_INFO_KHR;
    info.stageCount = static_cast<std::uint32_t>(stages.size());
    info.pStages = stages.data();
    info.groupCount = static_cast<std::uint32_t>(groups.size());
    info.pGroups = groups.data();
    info.maxPipelineRayRecursionDepth = 1;
    info.layout = layout_.get();
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(functions().create_ray_tracing_pipelines(context_->device(), VK_NULL_HANDLE, VK_NULL_HANDLE, 1, &info,
                                                   nullptr, &pipeline),
          "creating a ray tracing pipeline");
    program.pipeline = {context_->device(), pipeline};
    fill_table(program);
}

void Passes::fill_table(Program& program) {
    VkPhysicalDeviceRayTracingPipelinePropertiesKHR limits{};
    limits.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_PROPERTIES_KHR;
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &limits, {}};
    vkGetPhysicalDeviceProperties2(context_->physical_device(), &properties);
    const std::uint32_t handle = limits.shaderGroupHandleSize;
    const std::uint32_t stride =
        round_up(round_up(handle, limits.shaderGroupHandleAlignment), limits.shaderGroupBaseAlignment);
    std::vector<std::uint8_t> handles(std::size_t{handle} * 3);
    check(functions().get_group_handles(context_->device(), program.pipeline.get(), 0, 3, handles.size(),
                                        handles.data()),
          "reading shader group handles");
    const std::uint32_t slack = limits.shaderGroupBaseAlignment;
    program.table = Buffer(*context_, std::uint64_t{stride} * 3 + slack,
                           VK_BUFFER_USAGE_SHADER_BINDING_TABLE_BIT_KHR, Access::host);
    const VkDeviceAddress base = (program.table.address() + slack - 1) / slack * slack;
    auto* bytes = program.table.as<std::uint8_t>() + (base - program.table.address());
    for (std::uint32_t i = 0; i < 3; ++i)
        std::memcpy(bytes + std::size_t{stride} * i, handles.data() + std::size_t{handle} * i, handle);
    program.generation = {base, stride, stride};
    program.miss = {base + stride, stride, stride};
    program.hit = {base + 2 * std::uint64_t{stride}, stride, stride};
}

void Passes::record(VkCommandBuffer commands, Pass pass, VkDescriptorSet set, const gpu::PushData& push, int width,
                    int height) {
    const auto index = static_cast<std::size_t>(pass);
    Program& program = programs_[index];
    const bool by_pipeline = path_ == TracePath::pipeline;
    if (!program.pipeline) {
        if (by_pipeline) make_rays(program, pass);
        else make_compute(program, pass);
    }
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
