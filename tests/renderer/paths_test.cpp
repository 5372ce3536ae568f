// Two ways of tracing, and specialised or everything-on shaders: the same images.
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

TEST_P(Paths, RayQueryAndPipelineGiveEqualImages) {
    if (!device().info().ray_query || !device().info().ray_pipeline) GTEST_SKIP() << "the device has only one path";
    const Scene scene = lit_ball();
    const TestMap map = bumps(256);
    RenderSettings query = settings_of(scene), pipeline = query;
    query.path = TracePath::ray_query;
    pipeline.path = TracePath::pipeline;
    EXPECT_EQ(beauty_of(scene, map, query, 3), beauty_of(scene, map, pipeline, 3));
    EXPECT_EQ(depth_of(scene, map, query), depth_of(scene, map, pipeline));
}

TEST_P(Paths, PickIsTheSameOnBothPaths) {
    if (!device().info().ray_query || !device().info().ray_pipeline) GTEST_SKIP() << "the device has only one path";
    const Scene scene = lit_ball();
    const TestMap map = bumps(128);
    std::vector<std::vector<PickHit>> hits;
    for (const TracePath path : {TracePath::ray_query, TracePath::pipeline}) {
        RenderSettings settings = settings_of(scene);
        settings.path = path;
        Renderer r = make_renderer(scene, map, settings);
        hits.push_back(r.pick(std::vector{r.camera_ray(48.5, 48.5), r.camera_ray(1, 1), r.camera_ray(30, 60)}));
    }
    for (std::size_t i = 0; i < hits[0].size(); ++i) {
        EXPECT_EQ(hits[0][i].hit, hits[1][i].hit);
        EXPECT_EQ(hits[0][i].face, hits[1][i].face);
        EXPECT_EQ(hits[0][i].distance, hits[1][i].distance);
    }
    EXPECT_TRUE(hits[0][0].hit);
    EXPECT_FALSE(hits[0][1].hit);
}

// Bit for bit, whatever the scene leaves out.
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
    Renderer whole = make_renderer(scene, map, settings_of(scene)), parts = make_renderer(scene, map, settings_of(scene));
    whole.render();
    for (int y = 0; y < 96; y += 17) parts.render({0, y, 96, std::min(96, y + 17)}, Quality::full);
    EXPECT_EQ(parts.read_back(Layer::beauty), whole.read_back(Layer::beauty));
}

}  // namespace
}  // namespace relievo::test
