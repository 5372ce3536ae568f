// What a renderer holds on the device and beside it. Private to renderer*.cpp.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "renderer/albedo_file.h"
#include "renderer/beside.h"
#include "renderer/features.h"
#include "renderer/film.h"
#include "renderer/gpu_scene.h"
#include "renderer/mended_meshes.h"
#include "renderer/methods/registry.h"
#include "renderer/renderer.h"
#include "renderer/single_rays.h"
#include "renderer/vulkan/device_clock.h"
#include "renderer/vulkan/passes.h"

namespace relievo {

// Those whose programs are compiled.
using PassList = std::vector<vulkan::Pass>;

inline bool any_colours(std::span<const ColourView> colours) {
    return !std::ranges::all_of(colours, &ColourView::empty);
}

struct Renderer::State {
    vulkan::Context& context;
    vulkan::Commands commands;
    vulkan::DeviceClock clock;
    Scene scene;  // as rendered now: camera, lights and materials follow the setters
    RenderSettings settings;
    const Method* method;
    std::map<std::string, double> parameters;
    MendedMeshes mended;
    FeatureRequest request;
    Features features;
    std::optional<GpuScene> gpu_scene;
    Film film;
    vulkan::Buffer frame;
    SingleRays single_rays;
    vulkan::SetLayoutHandle set_layout;
    vulkan::DescriptorPoolHandle pool;
    VkDescriptorSet set = VK_NULL_HANDLE;
    vulkan::Passes passes;
    FeatureReport report;
    std::vector<AlbedoFile> albedo_files;  // of the objects that were given no colours; another method uploads them again
    std::vector<ColourView> colours;       // one an object; empty: none
    std::vector<HeightView> maps;  // as last uploaded: another method may need other structures over them
    int samples = 0;
    bool aov_is_fresh = false, counts_are_fresh = false;

    State(vulkan::Context& c, const Scene& s, const RenderSettings& r)
        : context(c), commands(c), clock(c), scene(s), settings(r), method(&find_method(r.method)),
          parameters(resolve_parameters(*method, r.parameters)), mended(scene) {}

    gpu::FrameData& frame_data() { return *frame.as<gpu::FrameData>(); }
    PixelRect whole() const { return {0, 0, film.width(), film.height()}; }
    PixelRect inside(const PixelRect& window) const {
        return {std::max(0, window.x0), std::max(0, window.y0), std::min(film.width(), window.x1),
                std::min(film.height(), window.y1)};
    }
    // What another method or other heights make anew. It is made beside what is in use, which stays until all is there.
    struct Made {
        const Method* method;
        std::map<std::string, double> parameters;
        FeatureRequest request;
        Features features;
        GpuScene scene;
        vulkan::Passes passes;
    };
    Made make(const Method& of, const std::map<std::string, double>& values, const SceneBefore& before,
              const PassList& compiled, const WorkPart& part);
    void take(Made made);
    // All of it, in the place of what is there. What it throws leaves all as it was.
    void make_anew(const Method& of, const std::map<std::string, double>& values, const SceneBefore& before,
                   const WorkProgress& progress);
    PassList programs_in_use() const;
    vulkan::Passes make_passes(const Method& of, const Features& by, const PassList& compiled, const WorkPart& part) const;

    void build(const WorkProgress& progress);
    void load_albedo_files();
    void write_addresses();
    void make_set();
    // Programs for these features, the listed ones compiled, in the place of what is there.
    void use_features(const Features& fresh, const PassList& compiled, const WorkProgress& progress);
    // The same where they differ, for the passes in use: at once if there is a `progress`, else at first use. True then.
    bool follow_features(const Features& fresh, const WorkProgress& progress = {});
    bool follow_search(const WorkProgress& progress = {});
    void apply_parameters();
    void write_own_bindings() const;
    void run(vulkan::Pass pass, const gpu::PushData& push, int width, int height);
    void run_unjittered(vulkan::Pass pass, const gpu::PushData& push, int width, int height);
    void count_bytes();
    void restart();
};

}  // namespace relievo
