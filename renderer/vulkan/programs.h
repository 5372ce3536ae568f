// Compiled pipelines, kept for the life of the device. To compile one takes a CPU device a second, and scenes
// and methods come back: another scene that needs the same features, a method that is chosen again, the
// second pane.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>

#include "renderer/trace_path.h"
#include "renderer/vulkan/resources.h"
#include "shaders/shared.h"

namespace relievo::vulkan {

// SPIR-V words of one shader: method "pdm", file "beauty.comp". Defined by the build (shader_code.cpp).
std::span<const std::uint32_t> shader_code(std::string_view method, std::string_view file);

using SpecConstants = std::array<std::uint32_t, gpu::kSpecCount>;

// All that a pipeline depends on. The descriptor set's layout is one for each path and number of objects,
// which is one of the constants.
struct ProgramKey {
    std::string method, file;  // of the compute shader or the ray generation
    TracePath path = TracePath::bvh;
    bool driver_triangles = false;  // the acceleration structure holds triangles, else boxes
    SpecConstants constants{};
    bool operator==(const ProgramKey&) const = default;
};

struct Program {
    PipelineHandle pipeline;
    Buffer table;  // shader binding table of a ray tracing pipeline
    VkStridedDeviceAddressRegionKHR generation{}, miss{}, hit{};
};

class Programs {
  public:
    // `most`: of those used last; beyond them, one that nobody holds is compiled again. At least 1. A driver for processors
    // keeps 8 to 12 MB of each.
    explicit Programs(std::size_t most) : most_(most) {}

    // Compiles at the first call for a key. Throws std::runtime_error where the device refuses, or the build
    // has no such shader. From any thread.
    std::shared_ptr<const Program> get(const Context& context, VkPipelineLayout layout,
                                       const ProgramKey& key);
    // Ever compiled. Some drivers compile at a program's first dispatch only.
    std::uint64_t compiled() const { return compiled_; }

  private:
    struct Kept {
        ProgramKey key;
        std::shared_ptr<const Program> program;
    };
    std::size_t most_;
    std::mutex mutex_;
    std::list<Kept> kept_;  // the last used first
    std::atomic<std::uint64_t> compiled_{0};
};

}  // namespace relievo::vulkan
