// What a ray costs, and its log: the same story as the picture, on all paths, without changing the picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/renderer/device.h"

namespace relievo::test::notes_test {
namespace {

RELIEVO_EVERY_METHOD(Notes);

TEST_P(Notes, CountingChangesNoLayerAndCountsWhatIsHit) {
    const Scene scene = make_scene(ball_mesh(), 0.3);
    const TestMap map = bumps(128);
    Renderer r = make_renderer(scene, map, settings_of(scene));
    const auto plain = r.read_back(Layer::depth), counts = r.read_back(Layer::counts);
    EXPECT_EQ(plain, r.read_back(Layer::depth));
    ASSERT_EQ(counts.size(), plain.size() * 4);
    for (std::size_t i = 0; i < plain.size(); ++i) {
        if (!std::isfinite(plain[i])) continue;
        ASSERT_GE(counts[4 * i], 1) << "boxes of pixel " << i;
        ASSERT_GE(counts[4 * i + 1] + counts[4 * i + 3], 1) << "steps and cells of pixel " << i;
        if (find_method(GetParam()).geometry == GeometryKind::triangles) continue;  // they were fetched when they were made
        ASSERT_GE(counts[4 * i + 2], 1) << "fetches of pixel " << i;
    }
}

TEST_P(Notes, LayersTracedWindowByWindowAreThoseOfTheWhole) {
    const Scene scene = make_scene(ball_mesh(), 0.3);
    const TestMap map = bumps(128);
    Renderer whole = make_renderer(scene, map, settings_of(scene)), parts = make_renderer(scene, map, settings_of(scene));
    whole.render();
    parts.render();
    for (const Layer layer : {Layer::beauty, Layer::depth, Layer::normal, Layer::uv, Layer::id, Layer::counts}) {
        const auto all = whole.read_back(layer);
        const std::size_t channels = all.size() / (96 * 96);
        for (const PixelRect& window : {PixelRect{0, 0, 40, 33}, PixelRect{40, 0, 96, 33}, PixelRect{0, 33, 200, 96}}) {
            EXPECT_GT(parts.trace_layers(window, layer == Layer::counts), 0);
            const auto part = parts.traced_layer(layer, window);
            const int x1 = std::min(window.x1, 96);
            ASSERT_EQ(part.size(), static_cast<std::size_t>((x1 - window.x0) * (window.y1 - window.y0)) * channels);
            auto at = part.begin();
            for (int y = window.y0; y < window.y1; ++y)
                for (int x = window.x0; x < x1; ++x)
                    for (std::size_t c = 0; c < channels; ++c, ++at) {
                        const float wanted = all[static_cast<std::size_t>(y * 96 + x) * channels + c];
                        // A driver meets the boxes in an order of its own, which may change from frame to frame.
                        if (layer == Layer::counts && device().info().best_path != TracePath::bvh)
                            ASSERT_EQ(*at > 0, wanted > 0) << x << ", " << y;
                        else
                            ASSERT_EQ(*at, wanted) << x << ", " << y;
                    }
        }
    }
}

TEST_P(Notes, LayersOfAnImageLargerThanTheDevicesLargestBufferAreWhole) {
    const Scene scene = make_scene(plane_mesh(), 0.2);
    const TestMap map = bumps(64);
    RenderSettings settings = settings_of(scene);
    settings.width = 512;
    settings.height = 6700;  // of 40 bytes a pixel: beyond the 128 MiB that a device may have as its limit
    Renderer r = make_renderer(scene, map, settings);
    std::vector<Ray> rays;
    for (int y = 0; y < settings.height; y += 134)
        for (int x = 0; x < settings.width; x += 101) rays.push_back(r.camera_ray(x + 0.5, y + 0.5));
    const auto depth = r.read_back(Layer::depth);
    const auto picked = r.pick(rays);
    std::size_t next = 0, hits = 0;
    for (int y = 0; y < settings.height; y += 134)
        for (int x = 0; x < settings.width; x += 101) {
            const PickHit& one = picked[next++];
            const float here = depth[static_cast<std::size_t>(y) * 512 + static_cast<std::size_t>(x)];
            ASSERT_EQ(one.hit, std::isfinite(here)) << x << ", " << y;
            if (one.hit) ASSERT_NEAR(one.distance, here, 1e-5f);
            hits += one.hit ? 1 : 0;
        }
    EXPECT_GT(hits, 20u);
}

TEST_P(Notes, CountsAreTakenAgainAfterAnEdit) {
    const Scene scene = make_scene(plane_mesh(), 0.3);
    TestMap map = make_map(64, 64, [](double, double) { return 0.5; });
    Renderer r = make_renderer(scene, map, settings_of(scene));
    const auto before = r.read_back(Layer::counts);
    const TestMap edited = bumps(64);
    const TexelRegion all{0, 0, 64, 64};
    r.upload(0, edited.view(), std::span(&all, 1));
    EXPECT_NE(before, r.read_back(Layer::counts));
}

TEST_P(Notes, LogEndsInTheHitThatPickingFinds) {
    const Scene scene = make_scene(ball_mesh(), 0.3);
    const TestMap map = bumps(128);
    for (const TracePath path : {TracePath::bvh, TracePath::ray_query, TracePath::pipeline}) {
        if (path == TracePath::ray_query && !device().info().ray_query) continue;
        if (path == TracePath::pipeline && !device().info().ray_pipeline) continue;
        RenderSettings settings = settings_of(scene);
        settings.path = path;
        Renderer r = make_renderer(scene, map, settings);
        const Ray ray = r.camera_ray(48.5, 48.5);
        const PickHit hit = r.pick(std::vector{ray})[0];
        const TraceLog log = r.trace_notes(ray);
        ASSERT_TRUE(hit.hit);
        EXPECT_TRUE(log.hit);
        EXPECT_EQ(log.distance, hit.distance);
        EXPECT_EQ(log.left_out, 0u);
        const auto is = [](TraceNote::Kind kind) { return [kind](const TraceNote& n) { return n.kind == kind; }; };
        EXPECT_GE(std::ranges::count_if(log.notes, is(TraceNote::Kind::box)), 1);
        const auto last = std::find_if(log.notes.rbegin(), log.notes.rend(), is(TraceNote::Kind::hit));
        ASSERT_NE(last, log.notes.rend());
        EXPECT_EQ(last->t, hit.distance);
        EXPECT_FALSE(r.trace_notes(r.camera_ray(1, 1)).hit);
    }
}

}  // namespace
}  // namespace relievo::test::notes_test
