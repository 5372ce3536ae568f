// Three ways of tracing, and specialised or everything-on shaders: the same images.
#include <gtest/gtest.h>

#include "brushes/map_file.h"
#include "tests/renderer/device.h"

namespace relievo::test::paths_test {
namespace {

RELIEVO_EVERY_METHOD(Paths);

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
        EXPECT_TRUE(same_image(beauty_of(scene, map, on(path, settings), 3), beauty)) << trace_path_words(path);
        EXPECT_TRUE(same_image(depth_of(scene, map, on(path, settings)), depth)) << trace_path_words(path);
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
            EXPECT_TRUE(same_image({float(hits[i].distance)}, {float(own[i].distance)})) << hits[i].distance;
        }
    }
}

TEST_P(Paths, EditsAreSeenOnAll) {
    const Scene scene = lit_ball();
    TestMap map = make_map(128, 128, [](double, double) { return 0.4; });
    TestMap edited = map;
    const TestMap from = bumps(128);
    const TexelRegion region{20, 30, 90, 100};
    for (int y = region.y0; y < region.y1; ++y)
        for (int x = region.x0; x < region.x1; ++x) {
            const auto at = static_cast<std::size_t>(y * 128 + x);
            edited.texels[at] = from.texels[at];
        }
    const auto edit = [&](TracePath path) {
        Renderer r = make_renderer(scene, map, on(path, settings_of(scene)));
        const UploadStats stats = r.upload(0, edited.view(), std::span(&region, 1));
        EXPECT_GT(stats.triangles_moved, 0);
        EXPECT_GT(stats.refit_ms, 0);
        r.set_displacement(0, 0.35, 0.4);
        return r.read_back(Layer::depth);
    };
    const auto own = edit(TracePath::bvh);
    for (const TracePath path : other_paths()) EXPECT_TRUE(same_image(edit(path), own)) << trace_path_words(path);
}

// Every sample scene, with its own map, textures and lights.
TEST_P(Paths, SampleScenesAreEqualOnAll) {
    for (const char* name : {"plane", "asteroid", "chainmail", "leather", "orb", "stump", "knot", "fur", "scree",
                             "procedural_plane", "procedural_sphere"}) {
        SCOPED_TRACE(name);
        const Scene scene = load_scene(std::string(RELIEVO_SAMPLE_SCENES) + "/" + name + ".json");
        std::vector<HeightMap> maps;
        std::vector<HeightView> views;
        for (const SceneObject& o : scene.objects) {
            const auto& procedural = o.displacement.procedural;
            maps.push_back(load_map(procedural ? procedural->exemplar : o.displacement.map).map);
        }
        for (const HeightMap& m : maps) views.push_back({m.width(), m.height(), m.texels().data()});
        const auto layers = [&](TracePath path) {
            RenderSettings settings = on(path, settings_of(scene));
            settings.width = settings.height = 80;
            Renderer r(device(), scene, views, settings);
            r.render();
            std::vector<std::vector<float>> images;
            for (const Layer layer :
                 {Layer::beauty, Layer::depth, Layer::normal, Layer::shading_normal, Layer::uv, Layer::id})
                images.push_back(r.read_back(layer));
            return images;
        };
        const auto own = layers(TracePath::bvh);
        for (const TracePath path : other_paths()) {
            const auto images = layers(path);
            for (std::size_t i = 0; i < own.size(); ++i) {
                if (!device().info().is_cpu) {
                    // Beside fur, a ten-thousandth of a texel turns a normal by as much as its slopes of hundreds say.
                    const bool normals = i == 2 || i == 3;
                    EXPECT_TRUE(same_image(images[i], own[i], normals ? 1e-3f : 1e-4f)) << trace_path_words(path) << ", layer " << i;
                    continue;
                }
                // Of two triangles met equally near, the pipeline keeps the one met last, the others the
                // first by index: single pixels on shared edges have the other one's normal.
                std::size_t apart = 0;
                for (std::size_t k = 0; k < own[i].size(); ++k) apart += own[i][k] != images[i][k] ? 1 : 0;
                const bool may_tie = path == TracePath::pipeline && i != 1;
                EXPECT_LE(apart, may_tie ? 6u : 0u) << trace_path_words(path) << ", layer " << i;
            }
        }
    }
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
        EXPECT_TRUE(same_image(beauty_of(scene, map, lean, 2), beauty_of(scene, map, all, 2)));
    }
}

// The background by the gradient's formula; on the ball, what faces the zenith is brighter than what turns
// away.
TEST_P(Paths, TheSkyLiesWhereItsZenithIs) {
    const TestMap map = bumps(64);
    for (const glm::dvec3 up : {glm::dvec3(0, 1, 0), glm::dvec3(0, -3, 0), glm::dvec3(1, 1, 0)}) {
        Scene scene = lit_ball();
        scene.lights.clear();
        scene.objects[0].material.specular = 0;
        scene.environment = {{1, 2, 3}, {0.5f, 0.5f, 0.5f}, {0, 0, 0}, up, 1};
        Renderer r = make_renderer(scene, map, settings_of(scene));
        r.render();
        const auto beauty = r.read_back(Layer::beauty), depth = r.read_back(Layer::depth),
                   normal = r.read_back(Layer::shading_normal);
        double lit = 0, dark = 0;  // means
        int lit_count = 0, dark_count = 0;
        for (std::size_t i = 0; i < depth.size(); ++i) {
            const auto towards = [&](const glm::vec3& v) {
                return glm::dot(glm::normalize(glm::dvec3(v)), glm::normalize(up));
            };
            if (std::isfinite(depth[i])) {
                const double facing = towards({normal[3 * i], normal[3 * i + 1], normal[3 * i + 2]});
                const double green = static_cast<double>(beauty[4 * i + 1]);
                if (facing > 0.5) lit += green, ++lit_count;
                if (facing < -0.5) dark += green, ++dark_count;
                continue;
            }
            const double h = towards(
                r.camera_ray(static_cast<double>(i % 96) + 0.5, static_cast<double>(i / 96) + 0.5).direction);
            const double wanted =
                h >= 0 ? 0.5 + 1.5 * std::sqrt(h) : 0.5 - 0.5 * std::sqrt(std::min(1.0, -4 * h));
            ASSERT_NEAR(beauty[4 * i + 1], wanted, 1e-3) << i;
        }
        EXPECT_GT(lit / lit_count, 2 * dark / dark_count);
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
}  // namespace relievo::test::paths_test
