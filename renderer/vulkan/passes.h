// The passes of one method as pipelines over one descriptor set, traced any way.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

#include "renderer/trace_path.h"
#include "renderer/vulkan/pass.h"
#include "renderer/vulkan/programs.h"
#include "shaders/shared.h"

namespace relievo::vulkan {

class Passes {
  public:
    Passes() = default;
    Passes(const Context& context, VkDescriptorSetLayout set_layout, std::string_view method, TracePath path,
           bool driver_triangles, bool bundles, const SpecConstants& constants);

    // Compiles the pass's program, where it was not yet.
    void make(Pass pass) { program(pass); }
    bool is_made(Pass pass) const { return programs_[static_cast<std::size_t>(pass)] != nullptr; }

    // Records the dispatch of width x height invocations (pick: width rays, height 1). Pipelines are made at first
    // use: a pass that nobody asks for is never compiled.
    void record(VkCommandBuffer commands, Pass pass, VkDescriptorSet set, const gpu::PushData& push, int width,
                int height);

  private:
    const Program& program(Pass pass);
    SpecConstants constants_of(Pass pass) const;

    const Context* context_ = nullptr;
    std::string_view method_;
    TracePath path_ = TracePath::ray_query;
    bool driver_triangles_ = false, bundles_ = false;
    SpecConstants constants_{};
    PipelineLayoutHandle layout_;
    std::array<std::shared_ptr<const Program>, kPassCount> programs_;
};

}  // namespace relievo::vulkan
