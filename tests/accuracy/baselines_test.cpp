// The baselines `march` and `tessellated` against the reference: their errors fall as they are refined, and
// nothing is open between neighbours.
#include <gtest/gtest.h>

#include <cstdio>

#include "renderer/judge/judge.h"
#include "renderer/stability/stability_case.h"
#include "renderer/vulkan/context.h"
#include "tests/accuracy/method_images.h"

namespace relievo::test::baselines_test {
namespace {

constexpr int kSize = 96;

stability::Case ball_case() {
    stability::SampleSurface ball;
    ball.mesh = stability::ball_mesh(32, 16);
    ball.amplitude = 0.2;
    ball.midlevel = 0.5;
    ball.paint(128, 128,
               [](int x, int y) { return stability::ball_dunes((x + 0.5) / 128, (y + 0.5) / 128); });
    stability::Case c;
    c.objects.push_back(ball);
    c.views = {{"front", {3.2, -0.7, 1.1}, {0, 0, 0}}};
    return c;
}

std::vector<ImageComparison> compared(const std::string& method, const std::string& parameter,
                                      const std::vector<double>& values) {
    const stability::Case c = ball_case();
    const Scene scene = c.scene(c.views[0]);
    const ReferenceSurface surface = c.reference();
    const Judge judge(trace_image(surface, scene.camera, scene.origin, kSize, kSize), scene);
    std::vector<ImageComparison> results;
    for (const double value : values) {
        const MethodImages images = method_images(scene, c.maps()[0], kSize, {method, {{parameter, value}}});
        results.push_back(judge.compare(images.depth, images.normal));
        std::printf("%s %s %g: %s\n", method.c_str(), parameter.c_str(), value,
                    results.back().text().c_str());
    }
    return results;
}

TEST(Baselines, TessellationNearsTheSurfaceAsItsDensityGrows) {
    const auto errors = compared("tessellated", "density", {0.25, 0.5, 1, 2});
    for (std::size_t i = 0; i < errors.size(); ++i) {
        EXPECT_EQ(errors[i].missed, 0) << "a gap between micro-triangles";
        if (i > 0) {
            EXPECT_LT(errors[i].depth.median, 0.6 * errors[i - 1].depth.median);
        }
    }
    EXPECT_LT(errors.back().depth.median, 1e-3);
}

TEST(Baselines, MarchingNearsTheSurfaceAsItsStepsGrow) {
    const auto errors = compared("march", "steps", {30, 100, 1000});
    for (std::size_t i = 1; i < errors.size(); ++i)
        EXPECT_LT(errors[i].depth.median, 0.5 * errors[i - 1].depth.median);
    EXPECT_LE(errors.back().missed + errors.back().invented, 1);
    EXPECT_LT(errors.back().depth.median, 1e-5);
}

TEST(Baselines, TooManyMicroTrianglesAreRefusedAndAllStaysAsItWas) {
    stability::Case c = ball_case();
    c.objects[0].paint(2048, 2048, [](int, int) { return 0.5; });
    vulkan::Context context{vulkan::ContextOptions{}};
    const auto maps = c.maps();
    RenderSettings settings;
    settings.width = settings.height = 16;
    Renderer renderer(context, c.scene(c.views[0]), maps, settings);
    const auto before = renderer.read_back(Layer::depth);
    try {
        renderer.set_method("tessellated", {{"density", 4}});
        FAIL() << "built";
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("at most 4194304 are made"), std::string::npos)
            << error.what();
    }
    EXPECT_EQ(renderer.read_back(Layer::depth), before);
}

}  // namespace
}  // namespace relievo::test::baselines_test
