// One validated context for all tests of the program.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "renderer/methods/registry.h"
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

inline std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const Method* m : methods()) names.emplace_back(m->name);
    return names;
}

// Tests that every registered method must pass: RELIEVO_EVERY_METHOD(Suite) makes the suite.
class EveryMethod : public testing::TestWithParam<std::string> {
  protected:
    static RenderSettings settings_of(const Scene& scene) {
        RenderSettings s = test::settings_of(scene);
        s.method = GetParam();
        return s;
    }
};

#define RELIEVO_EVERY_METHOD(Suite)                                                         \
    class Suite : public EveryMethod {};                                                    \
    INSTANTIATE_TEST_SUITE_P(EveryMethod, Suite, testing::ValuesIn(method_names()),         \
                             [](const auto& test) { return test.param; })

}  // namespace relievo::test
