// Rays that are traced one by one: buffers of picks and of one ray's log, made at the first wish for them.
#pragma once

#include <cstdint>
#include <span>

#include "renderer/gpu_scene.h"
#include "renderer/mended_meshes.h"
#include "renderer/renderer.h"
#include "renderer/vulkan/resources.h"

namespace relievo {

class SingleRays {
  public:
    static constexpr std::size_t kBatch = 256;  // rays a dispatch

    SingleRays() = default;
    explicit SingleRays(vulkan::Context& context);

    // True when buffers were made, and the bindings are to be written again.
    bool make_picks(vulkan::Context& context);
    bool make_notes(vulkan::Context& context);
    bool has_picks() const;
    bool has_notes() const;
    void write_bindings(VkDevice device, VkDescriptorSet set) const;

    // Before the pass: at most kBatch rays; forgets the log.
    void put(std::span<const Ray> rays);
    // After it, for the same rays.
    void take(const MendedMeshes& mended, std::span<const Ray> rays, std::span<PickHit> hits) const;
    TraceLog log(const GpuScene& scene) const;

    std::uint64_t pick_bytes() const { return rays_.bytes() + results_.bytes(); }
    std::uint64_t note_bytes() const { return notes_.bytes(); }

  private:
    vulkan::Buffer rays_, results_, notes_;
};

}  // namespace relievo
