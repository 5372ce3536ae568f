// See programs.h.
#include "renderer/vulkan/programs.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "renderer/vulkan/contraction.h"
#include "renderer/vulkan/functions.h"

namespace relievo::vulkan {
namespace {

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

std::uint32_t round_up(std::uint32_t value, std::uint32_t step) {
    return (value + step - 1) / step * step;
}

ShaderHandle module(const Context& context, std::string_view method, std::string_view file) {
    const auto given = shader_code(method, file);
    if (given.empty()) throw std::runtime_error("no shader '" + std::string(file) + "' in this build");
    const auto code = without_contraction(given);
    VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, nullptr, 0,
                                  code.size() * sizeof(std::uint32_t), code.data()};
    VkShaderModule shader = VK_NULL_HANDLE;
    check(vkCreateShaderModule(context.device(), &info, nullptr, &shader), "creating a shader module");
    return {context.device(), shader};
}

void make_compute(const Context& context, VkPipelineLayout layout, const ProgramKey& key, Program& program) {
    const ShaderHandle shader = module(context, key.method, key.file);
    const Specialisation specialisation(key.constants);
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage = stage(VK_SHADER_STAGE_COMPUTE_BIT, shader.get(), specialisation);
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(context.device(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          "creating a compute pipeline");
    program.pipeline = {context.device(), pipeline};
}

void fill_table(const Context& context, Program& program) {
    VkPhysicalDeviceRayTracingPipelinePropertiesKHR limits{};
    limits.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_TRACING_PIPELINE_PROPERTIES_KHR;
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &limits, {}};
    vkGetPhysicalDeviceProperties2(context.physical_device(), &properties);
    const std::uint32_t handle = limits.shaderGroupHandleSize;
    const std::uint32_t stride =
        round_up(round_up(handle, limits.shaderGroupHandleAlignment), limits.shaderGroupBaseAlignment);
    std::vector<std::uint8_t> handles(std::size_t{handle} * 3);
    check(functions().get_group_handles(context.device(), program.pipeline.get(), 0, 3, handles.size(),
                                        handles.data()),
          "reading shader group handles");
    const std::uint32_t slack = limits.shaderGroupBaseAlignment;
    program.table = Buffer(context, std::uint64_t{stride} * 3 + slack,
                           VK_BUFFER_USAGE_SHADER_BINDING_TABLE_BIT_KHR, Access::host);
    const VkDeviceAddress base = (program.table.address() + slack - 1) / slack * slack;
    auto* bytes = program.table.as<std::uint8_t>() + (base - program.table.address());
    for (std::uint32_t i = 0; i < 3; ++i)
        std::memcpy(bytes + std::size_t{stride} * i, handles.data() + std::size_t{handle} * i, handle);
    program.generation = {base, stride, stride};
    program.miss = {base + stride, stride, stride};
    program.hit = {base + 2 * std::uint64_t{stride}, stride, stride};
}

VkRayTracingShaderGroupCreateInfoKHR group(VkRayTracingShaderGroupTypeKHR type) {
    VkRayTracingShaderGroupCreateInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_RAY_TRACING_SHADER_GROUP_CREATE_INFO_KHR;
    info.type = type;
    info.generalShader = info.closestHitShader = info.anyHitShader = info.intersectionShader =
        VK_SHADER_UNUSED_KHR;
    return info;
}

// Whether rays ask the program about triangles that they meet: shaders/trace/triangles.glsl.
bool asks_about_triangles(const SpecConstants& constants) {
    return constants[gpu::kSpecOpacity] != 0 || constants[gpu::kSpecNotes] != gpu::kNotesNone;
}

void make_rays(const Context& context, VkPipelineLayout layout, const ProgramKey& key, Program& program) {
    const Specialisation specialisation(key.constants);
    std::vector<ShaderHandle> shaders;
    std::vector<VkPipelineShaderStageCreateInfo> stages;
    const auto add = [&](VkShaderStageFlagBits flag, std::string_view file) {
        shaders.push_back(module(context, key.method, file));
        stages.push_back(stage(flag, shaders.back().get(), specialisation));
        return static_cast<std::uint32_t>(stages.size() - 1);
    };
    std::array groups{
        group(VK_RAY_TRACING_SHADER_GROUP_TYPE_GENERAL_KHR),
        group(VK_RAY_TRACING_SHADER_GROUP_TYPE_GENERAL_KHR),
        group(key.driver_triangles ? VK_RAY_TRACING_SHADER_GROUP_TYPE_TRIANGLES_HIT_GROUP_KHR
                                   : VK_RAY_TRACING_SHADER_GROUP_TYPE_PROCEDURAL_HIT_GROUP_KHR)};
    auto& [generation, miss, hit] = groups;
    generation.generalShader = add(VK_SHADER_STAGE_RAYGEN_BIT_KHR, key.file);
    miss.generalShader = add(VK_SHADER_STAGE_MISS_BIT_KHR, "miss.rmiss");
    hit.closestHitShader = add(VK_SHADER_STAGE_CLOSEST_HIT_BIT_KHR, "hit.rchit");
    if (!key.driver_triangles)
        hit.intersectionShader = add(VK_SHADER_STAGE_INTERSECTION_BIT_KHR, "hit.rint");
    else if (asks_about_triangles(key.constants))
        hit.anyHitShader = add(VK_SHADER_STAGE_ANY_HIT_BIT_KHR, "hit.rahit");
    VkRayTracingPipelineCreateInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_RAY_TRACING_PIPELINE_CREATE_INFO_KHR;
    info.stageCount = static_cast<std::uint32_t>(stages.size());
    info.pStages = stages.data();
    info.groupCount = static_cast<std::uint32_t>(groups.size());
    info.pGroups = groups.data();
    info.maxPipelineRayRecursionDepth = 1;
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(functions().create_ray_tracing_pipelines(context.device(), VK_NULL_HANDLE, VK_NULL_HANDLE, 1, &info,
                                                   nullptr, &pipeline),
          "creating a ray tracing pipeline");
    program.pipeline = {context.device(), pipeline};
    fill_table(context, program);
}

}  // namespace

std::shared_ptr<const Program> Programs::get(const Context& context, VkPipelineLayout layout,
                                             const ProgramKey& key) {
    const std::lock_guard lock(mutex_);
    const auto known =
        std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.key == key; });
    if (known != kept_.end()) {
        kept_.splice(kept_.begin(), kept_, known);
        return kept_.front().program;
    }
    auto program = std::make_shared<Program>();
    if (key.path == TracePath::pipeline)
        make_rays(context, layout, key, *program);
    else
        make_compute(context, layout, key, *program);
    ++compiled_;
    kept_.push_front({key, program});
    if (kept_.size() > most_) kept_.pop_back();
    return program;
}

}  // namespace relievo::vulkan
