// The passes (beauty, layers, pick, and the last two again with notes taken) of one method as pipelines over one descriptor set, traced any way.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "renderer/trace_path.h"
#include "renderer/vulkan/resources.h"
#include "shaders/shared.h"

namespace relievo::vulkan {

enum class Pass {
    beauty,
    aov,
    pick,
    counts,  // aov, counting what each pixel's ray costs
    notes,   // pick of one ray, logged
};
constexpr std::size_t kPassCount = 5;

// SPIR-V words of one shader: method "pdm", file "beauty.comp". Defined by the build (shader_code.cpp).
std::span<const std::uint32_t> shader_code(std::string_view method, std::string_view file);

using SpecConstants = std::array<std::uint32_t, gpu::kSpecCount>;

class Passes {
  public:
    Passes() = default;
    Passes(const Context& context, VkDescriptorSetLayout set_layout, std::string_view method, TracePath path,
           const SpecConstants& constants);

    // Records the dispatch of width x height invocations (pick: width rays, height 1). Pipelines are made at first
    // use: a pass that nobody asks for is never compiled.
    void record(VkCommandBuffer commands, Pass pass, VkDescriptorSet set, const gpu::PushData& push, int width,
                int height);

  private:
    struct Program {
        PipelineHandle pipeline;
        Buffer table;  // shader binding table of the ray tracing pipeline
        VkStridedDeviceAddressRegionKHR generation{}, miss{}, hit{};
    };
    void make_compute(Program& program, Pass pass);
    void make_rays(Program& program, Pass pass);
    SpecConstants constants_of(Pass pass) const;
    void fill_table(Program& program);
    ShaderHandle module(std::string_view file) const;

    const Context* context_ = nullptr;
    std::string_view method_;
    TracePath path_ = TracePath::ray_query;
    SpecConstants constants_{};
    PipelineLayoutHandle layout_;
    std::array<Program, kPassCount> programs_;
};

}  // namespace relievo::vulkan
