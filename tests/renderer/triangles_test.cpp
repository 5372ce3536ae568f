// Micro-triangles in the driver's own acceleration structure: what the method `tessellated` promises of them.
#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/features.h"
#include "tests/renderer/device.h"

namespace relievo::test::triangles_test {
namespace {

class DriverTriangles : public testing::Test {
  protected:
    void SetUp() override {
        if (other_paths().empty()) GTEST_SKIP() << "this device has no ray tracing";
    }

    static RenderSettings on(TracePath path, const Scene& scene) {
        RenderSettings settings = settings_of(scene);
        settings.method = "tessellated";
        settings.parameters = {{"density", 1}};
        settings.path = path;
        return settings;
    }
};

// Straight down at the corners of a plane's micro-triangles, `rows` a side, and at the middle of their edges:
// edge values are 0.
std::vector<Ray> rays_at_corners(int rows) {
    std::vector<Ray> rays;
    for (int y = 1; y < 2 * rows; ++y)
        for (int x = 1; x < 2 * rows; ++x)
            rays.push_back({{static_cast<float>(x) / static_cast<float>(rows) - 1, 3,
                             static_cast<float>(y) / static_cast<float>(rows) - 1},
                            {0, -1, 0}});
    return rays;
}

// At the same places aslant: edge values are a rounding away from 0, on either side.
std::vector<Ray> aslant(const std::vector<PickHit>& hits) {
    const glm::vec3 direction = glm::normalize(glm::vec3(0.13f, -1, 0.29f));
    std::vector<Ray> rays;
    for (const PickHit& hit : hits) rays.push_back({hit.position - 3.0f * direction, direction});
    return rays;
}

// Which of the triangles around a corner is met may differ, and with it the last bits.
TEST_F(DriverTriangles, NoRayPassesBetweenThemAndAllPathsTellItsDistance) {
    constexpr int kRows = 64;
    const Scene scene = make_scene(plane_mesh(), 0.1);
    const TestMap map = bumps(kRows);
    Renderer own = make_renderer(scene, map, on(TracePath::bvh, scene));
    const std::vector<Ray> down = rays_at_corners(kRows), slanted = aslant(own.pick(down));
    for (const std::vector<Ray>& rays : {down, slanted}) {
        const auto expected = own.pick(rays);
        for (const TracePath path : other_paths()) {
            SCOPED_TRACE(trace_path_words(path));
            const auto hits = make_renderer(scene, map, on(path, scene)).pick(rays);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                ASSERT_TRUE(hits[i].hit && expected[i].hit) << i;
                ASSERT_NEAR(hits[i].distance, expected[i].distance, 2e-6f) << i;
            }
        }
    }
}

// Where there may be holes, and where it counts, the program is asked about every triangle that the driver
// meets.
TEST_F(DriverTriangles, ThoseAskedAboutAndThoseMetByTheDriverAloneGiveOneImage) {
    const Scene scene = lit_ball();
    const TestMap map = bumps(128);
    for (const TracePath path : other_paths()) {
        SCOPED_TRACE(trace_path_words(path));
        RenderSettings lean = on(path, scene), all = lean;
        all.everything = true;
        EXPECT_TRUE(same_image(beauty_of(scene, map, lean, 2), beauty_of(scene, map, all, 2)));
        Renderer r = make_renderer(scene, map, lean);
        const auto depth = r.read_back(Layer::depth), counts = r.read_back(Layer::counts);
        EXPECT_TRUE(same_image(r.read_back(Layer::depth), depth));
        for (std::size_t i = 0; i < depth.size(); ++i) {
            if (!std::isfinite(depth[i])) continue;
            ASSERT_GE(counts[4 * i], 1) << "triangles met by the ray of pixel " << i;
            ASSERT_EQ(counts[4 * i], counts[4 * i + 1]) << "a step each";
        }
    }
}

TEST_F(DriverTriangles, TheReportTellsOfThemAndOfNoBoxes) {
    const Scene scene = lit_ball();
    const TestMap map = bumps(128);
    const auto reported = [&](TracePath path, std::string_view name) {
        const Renderer r = make_renderer(scene, map, on(path, scene));
        const auto& features = r.features().features;
        return *std::ranges::find(features, name, &Feature::name);
    };
    const Feature own = reported(TracePath::bvh, "micro-triangles");
    EXPECT_EQ(reported(TracePath::bvh, "surface bounds").reason,
              "method tessellated meets micro-triangles, and boxes hold each of them");
    for (const TracePath path : other_paths()) {
        EXPECT_EQ(reported(path, "micro-triangles").bytes, own.bytes);
        EXPECT_GT(reported(path, trace_path_words(path)).bytes, 0u);
        EXPECT_EQ(reported(path, "surface bounds").reason,
                  "method tessellated meets micro-triangles, which the driver's structure holds itself");
    }
}

}  // namespace
}  // namespace relievo::test::triangles_test
