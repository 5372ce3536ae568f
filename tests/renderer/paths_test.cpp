// Three ways of tracing, and specialised or everything-on shaders: the same images.
#include <gtest/gtest.h>

#include "tests/renderer/device.h"

namespace relievo::test {
namespace {

Scene lit_ball() {
    Scene scene = make_scene(ball_mesh(), 0.3);
    Light point;
    point.kind = Light::Kind::point;
    point.position = {2, 2, 1};
    point.radius = 0.3f;
    scene.lights.push_back(point);
    return scene;
}

RELIEVO_EVERY_METHOD(Paths);

// Ours is the one that any device takes; the others are compared with it.
std::vector<TracePath> other_paths() {
    std::vector<TracePath> paths;
    if (device().info().ray_query) paths.push_back(TracePath::ray_query);
    if (device().info().ray_pipeline) paths.push_back(TracePath::pipeline);
    return paths;
}

RenderSettings on(TracePath path, RenderSettings settings) {
    settings.path = path;
    return settings;
}

TEST_P(Paths, AllGiveEqualImages) {
    const Scene scene = lit_ball();
    const TestMap map = bumps(256);
    const RenderSettings settings = settings_of(scene), own = on(TracePath::bvh, settings);
    const auto beauty = beauty_of(scene, map, own, 3), depth = depth_of(scene, map, own);
    for (const TracePath path : other_paths()) {
        EXPECT_EQ(beauty_of(scene, map, on(path, settings), 3), beauty) << trace_path_words(path);
        EXPECT_EQ(depth_of(scene, map, on(path, settings)), depth) << trace_path_words(path);
    }
}

TEST_P(Paths, PickIsTheSameOnAll) {
    const Scene scene = lit_ball();
    const TestMap map = bumps(128);
    const auto pick = [&](TracePath path) {
        Renderer r = make_renderer(scene, map, on(path, settings_of(scene)));
        return r.pick(std::vector{r.camera_ray(48.5, 48.5), r.camera_ray(1, 1), r.camera_ray(30, 60)});
    };
    const auto own = pick(TracePath::bvh);
    EXPECT_TRUE(own[0].hit);
    EXPECT_FALSE(own[1].hit);
    for (const TracePath path : other_paths()) {
        const auto hits = pick(path);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            EXPECT_EQ(hits[i].hit, own[i].hit);
            EXPECT_EQ(hits[i].face, own[i].face);
            EXPECT_EQ(hits[i].distance, own[i].distance);
        }
    }
}

TEST_P(Paths, EditsAreSeenOnAll) {
    const Scene scene = lit_ball();
    TestMap map = make_map(128, 128, [](double, double) { return 0.4; });
    const TestMap edited = bumps(128);
    const TexelRegion region{20, 30, 90, 100};
    const auto edit = [&](TracePath path) {
        Renderer r = make_renderer(scene, map, on(path, settings_of(scene)));
        const UploadStats stats = r.upload(0, edited.view(), std::span(&region, 1));
        EXPECT_GT(stats.triangles_grown, 0);
        EXPECT_GT(stats.refit_ms, 0);
        r.set_displacement(0, 0.35, 0.4);
        return r.read_back(Layer::depth);
    };
    const auto own = edit(TracePath::bvh);
    for (const TracePath path : other_paths()) EXPECT_EQ(edit(path), own) << trace_path_words(path);
}

TEST_P(Paths, SpecialisedImageEqualsEverythingOn) {
    const TestMap map = bumps(256);
    Scene matte = lit_ball(), dark_sky = lit_ball(), no_lights = lit_ball();
    matte.objects[0].material.specular = 0;
    dark_sky.environment.intensity = 0;
    no_lights.lights.clear();
    for (const Scene& scene : {matte, dark_sky, no_lights}) {
        RenderSettings lean = settings_of(scene), all = lean;
        all.everything = true;
        EXPECT_TRUE(beauty_of(scene, map, lean, 2) == beauty_of(scene, map, all, 2));
    }
}

TEST_P(Paths, PickAgreesWithTheDepthLayer) {
    const Scene scene = lit_ball();
    const TestMap map = bumps(256);
    Renderer r = make_renderer(scene, map, settings_of(scene));
    const auto depth = r.read_back(Layer::depth);
    std::vector<Ray> rays;
    for (int y = 0; y < 96; y += 5)
        for (int x = 0; x < 96; x += 5) rays.push_back(r.camera_ray(x + 0.5, y + 0.5));
    const auto hits = r.pick(rays);
    std::size_t i = 0;
    for (std::size_t y = 0; y < 96; y += 5)
        for (std::size_t x = 0; x < 96; x += 5, ++i) {
            const float z = depth[y * 96 + x];
            ASSERT_EQ(hits[i].hit, std::isfinite(z));
            if (hits[i].hit) {
                ASSERT_NEAR(hits[i].distance, z, 1e-5);
            }
        }
}

TEST_P(Paths, PreviewIsReplacedByTheFirstSample) {
    const Scene scene = lit_ball();
    const TestMap map = bumps(128);
    Renderer r = make_renderer(scene, map, settings_of(scene));
    r.render();
    r.render();
    const auto whole = r.read_back(Layer::beauty);
    r.restart();
    r.render({10, 10, 60, 60}, Quality::preview);
    EXPECT_EQ(r.samples(), 0);
    r.render();
    r.render();
    EXPECT_EQ(r.read_back(Layer::beauty), whole);
}

TEST_P(Paths, WindowsOfAPassGiveTheWholeImage) {
    const Scene scene = lit_ball();
    const TestMap map = bumps(128);
    Renderer whole = make_renderer(scene, map, settings_of(scene)),
             parts = make_renderer(scene, map, settings_of(scene));
    whole.render();
    for (int y = 0; y < 96; y += 17) parts.render({0, y, 96, std::min(96, y + 17)}, Quality::full);
    EXPECT_EQ(parts.read_back(Layer::beauty), whole.read_back(Layer::beauty));
}

}  // namespace
}  // namespace relievo::test
