// What a renderer holds on the device and beside it. Private to renderer*.cpp.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "renderer/albedo_file.h"
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
    void build();
    void build_scene();
    void load_albedo_files();
    void rebuild_for(const Method& method);
    void write_addresses();
    void make_set();
    void make_passes();
    void follow_search();
    void apply_parameters();
    void write_own_bindings() const;
    void run(vulkan::Pass pass, const gpu::PushData& push, int width, int height);
    void run_unjittered(vulkan::Pass pass, const gpu::PushData& push, int width, int height);
    void count_bytes();
    void restart();
};

}  // namespace relievo
