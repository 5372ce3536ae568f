// The live path: after an edit the image is that of a renderer built afresh, and only what moved was refitted.
#include <gtest/gtest.h>

#include "tests/renderer/device.h"

namespace relievo::test::live_edit_test {
namespace {

void raise(TestMap& map, const TexelRegion& r, std::uint16_t count) {
    for (int y = r.y0; y < r.y1; ++y)
        for (int x = r.x0; x < r.x1; ++x) map.texels[static_cast<std::size_t>(y * map.width + x)] = count;
}

RELIEVO_EVERY_METHOD(LiveEdit);

TEST_P(LiveEdit, UploadEqualsARendererBuiltAfresh) {
    const Scene scene = make_scene(ball_mesh(), 0.3);
    TestMap map = bumps(256);
    Renderer live = make_renderer(scene, map, settings_of(scene));
    const std::vector<TexelRegion> regions{{20, 130, 90, 170}, {200, 100, 256, 140}, {0, 0, 3, 5}};
    for (const TexelRegion& r : regions) raise(map, r, 65535);
    const UploadStats stats = live.upload(0, map.view(), regions);
    EXPECT_GT(stats.triangles_moved, 0);
    EXPECT_LT(stats.triangles_moved, 300);
    const auto a = live.read_back(Layer::depth), b = depth_of(scene, map, settings_of(scene));
    EXPECT_EQ(a, b);
}

// So large that `exact` keeps no bounds of the finest level.
TEST(LiveEditOfALargeMap, UploadEqualsARendererBuiltAfresh) {
    Scene scene = make_scene(ball_mesh(), 0.3);
    scene.method.name = "exact";
    TestMap map{4096, 4096, {}};
    for (int i = 0; i < 4096 * 4096; ++i)
        map.texels.push_back(static_cast<std::uint16_t>(32768 + (i % 4096 & 511) * 40 - (i >> 17) * 200));
    Renderer live = make_renderer(scene, map, settings_of(scene));
    const TexelRegion regions[] = {{300, 2100, 1500, 2700}, {4000, 1500, 4096, 2400}};
    for (const TexelRegion& r : regions) raise(map, r, 65535);
    live.upload(0, map.view(), regions);
    const auto a = live.read_back(Layer::depth), b = depth_of(scene, map, settings_of(scene));
    int hits = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(std::isfinite(a[i]), std::isfinite(b[i])) << i;
        if (!std::isfinite(a[i])) continue;
        ASSERT_NEAR(a[i], b[i], 1e-5f) << i;
        ++hits;
    }
    EXPECT_GT(hits, 1000);
}

TEST_P(LiveEdit, NothingIsRefittedWhenTheHeightsStayWithinTheirBounds) {
    const Scene scene = make_scene(plane_mesh(), 0.3);
    TestMap map = make_map(128, 128, [](double u, double) { return u < 0.1 ? 0.0 : u > 0.9 ? 1.0 : 0.5; });
    Renderer live = make_renderer(scene, map, settings_of(scene));
    const TexelRegion r{40, 40, 80, 80};
    raise(map, r, 60000);
    const UploadStats stats = live.upload(0, map.view(), std::span(&r, 1));
    EXPECT_EQ(stats.triangles_touched, 2);
    if (find_method(GetParam()).geometry == GeometryKind::triangles) {  // moves the touched ones, whatever happens
        EXPECT_EQ(stats.triangles_moved, 2);
        return;
    }
    EXPECT_EQ(stats.triangles_moved, 0);
    EXPECT_EQ(stats.refit_ms, 0);
}

TEST_P(LiveEdit, AmplitudeAndMidlevelChangeLive) {
    const TestMap map = bumps(128);
    const Scene small = make_scene(ball_mesh(), 0.1, 0.5), large = make_scene(ball_mesh(), -0.6, 0.2);
    Renderer live = make_renderer(small, map, settings_of(small));
    live.set_displacement(0, -0.6, 0.2);
    EXPECT_EQ(live.read_back(Layer::depth), depth_of(large, map, settings_of(large)));
}

// So many triangles that it is stopped on its way.
TEST(LiveEditOfADenseMesh, AStoppedAmplitudeLeavesAllAsItWas) {
    struct Stop {};
    const TestMap map = bumps(128);
    const auto scene_of = [](double amplitude, double midlevel) {
        Scene scene = make_scene(ball_mesh(160, 80), amplitude, midlevel);
        scene.method.name = "exact";
        return scene;
    };
    const Scene scene = scene_of(0.1, 0.5), wanted = scene_of(-0.4, 0.2);
    Renderer live = make_renderer(scene, map, settings_of(scene));
    const auto before = live.read_back(Layer::depth);
    for (const double last : {0.0, 0.1, 0.4, 0.65, 0.8, 0.95, 1.0}) {
        EXPECT_THROW(live.set_displacement(0, -0.4, 0.2, [&](double part) { if (part >= last) throw Stop(); }), Stop);
        EXPECT_EQ(live.read_back(Layer::depth), before) << last;
    }
    live.set_displacement(0, -0.4, 0.2, [](double) {});
    EXPECT_EQ(live.read_back(Layer::depth), depth_of(wanted, map, settings_of(wanted)));
}

TEST_P(LiveEdit, OnlyTheWindowLosesItsSamples) {
    const Scene scene = make_scene(plane_mesh(), 0.2);
    const TestMap map = bumps(64);
    Renderer r = make_renderer(scene, map, settings_of(scene));
    r.render();
    const auto before = r.read_back(Layer::beauty);
    r.restart({8, 8, 24, 24});
    const auto after = r.read_back(Layer::beauty);
    for (std::size_t y = 0; y < 96; ++y)
        for (std::size_t x = 0; x < 96; ++x) {
            const bool inside = x >= 8 && x < 24 && y >= 8 && y < 24;
            ASSERT_EQ(after[(y * 96 + x) * 4], inside ? 0.0f : before[(y * 96 + x) * 4]);
        }
}

}  // namespace
}  // namespace relievo::test::live_edit_test
