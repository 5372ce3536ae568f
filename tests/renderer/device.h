// One validated context for all tests of the program.
#pragma once

#include "renderer/vulkan/context.h"
#include "tests/support/scenes.h"

namespace relievo::test {

inline vulkan::Context& device() {
    static vulkan::Context context({.device = "", .validation = true, .for_window = false});
    return context;
}

inline Renderer make_renderer(const Scene& scene, const TestMap& map, const RenderSettings& settings) {
    const HeightView view = map.view();
    return Renderer(device(), scene, std::span(&view, 1), settings);
}

inline std::vector<float> depth_of(const Scene& scene, const TestMap& map, const RenderSettings& settings) {
    return make_renderer(scene, map, settings).read_back(Layer::depth);
}

inline std::vector<float> beauty_of(const Scene& scene, const TestMap& map, const RenderSettings& settings, int spp) {
    Renderer r = make_renderer(scene, map, settings);
    for (int i = 0; i < spp; ++i) r.render();
    return r.read_back(Layer::beauty);
}

}  // namespace relievo::test
