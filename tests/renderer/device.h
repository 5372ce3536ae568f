// What the renderer's tests share.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "renderer/methods/registry.h"
#include "tests/support/device.h"
#include "tests/support/scenes.h"

namespace relievo::test {

// The ways of tracing beside our own, which any device takes.
inline std::vector<TracePath> other_paths() {
    std::vector<TracePath> paths;
    if (device().info().ray_query) paths.push_back(TracePath::ray_query);
    if (device().info().ray_pipeline) paths.push_back(TracePath::pipeline);
    return paths;
}

inline Renderer make_renderer(const Scene& scene, const TestMap& map, const RenderSettings& settings,
                              vulkan::Context& context = device()) {
    const HeightView view = map.view();
    return Renderer(context, scene, std::span(&view, 1), settings);
}

inline std::vector<float> depth_of(const Scene& scene, const TestMap& map, const RenderSettings& settings) {
    return make_renderer(scene, map, settings).read_back(Layer::depth);
}

inline std::vector<float> beauty_of(const Scene& scene, const TestMap& map, const RenderSettings& settings, int spp) {
    Renderer r = make_renderer(scene, map, settings);
    for (int i = 0; i < spp; ++i) r.render();
    return r.read_back(Layer::beauty);
}

// Two programs that trace the same, one specialised and one not, or by two ways: on a CPU the same bits. A GPU's compiler
// may turn a division or a normalisation into other instructions in each; then the same to `rounding`, but for single
// pixels at silhouettes.
inline ::testing::AssertionResult same_image(const std::vector<float>& a, const std::vector<float>& b,
                                             float rounding = 1e-4f) {
    if (a == b) return ::testing::AssertionSuccess();
    if (a.size() != b.size()) return ::testing::AssertionFailure() << a.size() << " and " << b.size() << " values";
    std::size_t bits = 0, far_apart = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] == b[i]) continue;
        ++bits;
        if (!(std::abs(a[i] - b[i]) <= rounding * (1 + std::abs(b[i])))) ++far_apart;
    }
    if (!device().info().is_cpu && far_apart * 100 <= a.size()) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << bits << " of " << a.size() << " values differ, " << far_apart
                                         << " by more than rounding";
}

inline std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const Method* m : methods()) names.emplace_back(m->name);
    return names;
}

// Tests that every registered method must pass: RELIEVO_EVERY_METHOD(Suite) makes the suite, and RELIEVO_FOR_EVERY_METHOD
// runs one of its own.
class EveryMethod : public testing::TestWithParam<std::string> {
  protected:
    static RenderSettings settings_of(const Scene& scene) {
        RenderSettings s = test::settings_of(scene);
        s.method = GetParam();
        return s;
    }
};

#define RELIEVO_FOR_EVERY_METHOD(Suite)                                             \
    INSTANTIATE_TEST_SUITE_P(EveryMethod, Suite, testing::ValuesIn(method_names()), \
                             [](const auto& test) { return test.param; })

#define RELIEVO_EVERY_METHOD(Suite)      \
    class Suite : public EveryMethod {}; \
    RELIEVO_FOR_EVERY_METHOD(Suite)

}  // namespace relievo::test
