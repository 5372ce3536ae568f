// Every judged surface from all its views: `exact` within its promises, `pdm` at dt 0.001 within its own.
#include "tests/accuracy/surfaces.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "renderer/judge/judge.h"
#include "tests/accuracy/limits.h"
#include "tests/accuracy/method_images.h"

namespace relievo::test {
namespace {

constexpr int kSize = 96;

Scene scene_of(const JudgedSurface& surface, const NamedView& view) {
    Scene scene;
    SceneObject object;
    object.displacement.amplitude = surface.sample.amplitude;
    object.displacement.midlevel = surface.sample.midlevel;
    object.displacement.wrap = surface.sample.wrap;
    object.mesh = surface.sample.mesh;
    scene.objects.push_back(object);
    scene.origin = surface.origin;
    scene.camera.eye = view.eye + surface.origin;
    scene.camera.look_at = view.look_at + surface.origin;
    scene.camera.up = {0, 0, 1};
    scene.camera.fov_deg = 50;
    return scene;
}

class JudgedSurfaces : public testing::TestWithParam<std::string> {
  protected:
    const JudgedSurface judged_ = judged_surface(GetParam());
    const ReferenceSurface surface_ = judged_.sample.reference();

    ImageComparison compare(const Scene& scene, const Judge& judge, const MethodUnderTest& method,
                            const char* view) const {
        const SampleSurface& sample = judged_.sample;
        const MethodImages images =
            method_images(scene, {sample.width, sample.height, sample.texels.data()}, kSize, method);
        ImageComparison result = judge.compare(images.depth, images.normal);
        if (method.name == "exact") judge.count_unexplained(surface_, images.depth, result);
        std::printf("%s, %s, %s: %s\n", method.name.c_str(), judged_.name.c_str(), view,
                    result.text().c_str());
        return result;
    }
};

TEST_P(JudgedSurfaces, AreMetAsPromised) {
    for (const NamedView& view : judged_.views) {
        SCOPED_TRACE(view.name);
        const Scene scene = scene_of(judged_, view);
        const Judge judge(trace_image(surface_, scene.camera, scene.origin, kSize, kSize), scene);
        EXPECT_EQ(judge.image().undecided, 0u);
        expect_exact(compare(scene, judge, exact_method(), view.name), judged_.exact_wrong, view.median);
        const ImageComparison sampled = compare(scene, judge, pdm_method(), view.name);
        if (judged_.sampled == Sampled::within_limits) expect_sampled(sampled);
        if (judged_.sampled == Sampled::known_flaw) {
            EXPECT_LE(sampled.depth.median, 0.1);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, JudgedSurfaces, testing::ValuesIn(judged_surface_names()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace relievo::test
