// Rays that walk the tree in bundles (shaders/trace/bundle.glsl) and rays that walk alone (bvh.glsl): the same bits, whatever
// the bundle is: cut off by the image's border, of rays in all directions, with a stack that fills all its parts.
#include <gtest/gtest.h>

#include "tests/renderer/device.h"

namespace relievo::test::bundles_test {
namespace {

class Bundles : public EveryMethod {
  protected:
    void SetUp() override {
        if (!device().info().bundles) GTEST_SKIP() << "this device's rays walk alone";
    }

    static vulkan::Context& lone_walkers() {
        static vulkan::Context context({.device = "", .validation = true, .bundles = false});
        return context;
    }
};

RELIEVO_FOR_EVERY_METHOD(Bundles);

RenderSettings of_size(RenderSettings settings, int width, int height) {
    settings.path = TracePath::bvh;
    settings.width = width;
    settings.height = height;
    return settings;
}

TEST_P(Bundles, ImagesOfAnySizeAndWindowAreEqual) {
    const Scene scene = lit_ball(ball_mesh(64, 32));
    const TestMap map = bumps(128);
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 50}, {61, 37}}) {
        const RenderSettings settings = of_size(settings_of(scene), width, height);
        const auto images = [&](vulkan::Context& context) {
            Renderer r = make_renderer(scene, map, settings, context);
            r.render();
            r.render();
            auto all = std::vector{r.read_back(Layer::beauty), r.read_back(Layer::depth), r.read_back(Layer::normal),
                                   r.read_back(Layer::id)};
            r.restart();
            r.render({width / 3, height / 3, width - width / 4, height - height / 5}, Quality::preview);
            all.push_back(r.read_back(Layer::beauty));
            return all;
        };
        EXPECT_EQ(images(device()), images(lone_walkers())) << width << " x " << height;
    }
}

TEST_P(Bundles, RaysInAllDirectionsMeetTheSame) {
    const Scene scene = lit_ball(ball_mesh(64, 32));
    const TestMap map = bumps(64);
    std::vector<Ray> rays;
    for (int i = 0; i < 300; ++i) {
        const double a = 2.4 * i, h = 1 - 2 * (i + 0.5) / 300, w = std::sqrt(1 - h * h);
        const glm::dvec3 direction(w * std::cos(a), h, w * std::sin(a));
        // From inside, from far away, from beside the ball, and away from it.
        const double along[] = {0.0, -50.0, -3.0, 3.0};
        rays.push_back({direction * along[i % 4] + glm::dvec3(0.1 * (i % 7), 0, 0), direction});
    }
    for (const std::size_t count : {std::size_t{1}, std::size_t{7}, rays.size()}) {
        const auto picked = [&](vulkan::Context& context) {
            Renderer r = make_renderer(scene, map, of_size(settings_of(scene), 8, 8), context);
            return r.pick(std::span(rays).first(count));
        };
        const auto together = picked(device()), alone = picked(lone_walkers());
        int hits = 0;
        for (std::size_t i = 0; i < count; ++i) {
            ASSERT_EQ(together[i].hit, alone[i].hit) << i;
            if (!alone[i].hit) continue;
            ++hits;
            ASSERT_EQ(together[i].distance, alone[i].distance) << i;
            ASSERT_EQ(together[i].face, alone[i].face) << i;
        }
        EXPECT_GT(hits, 0);
    }
}

// Quads one below the other, all of which a ray through them meets: no tree has more nodes that wait. They face up and down
// by turns: rays through a flat sheet of so many would walk alone.
MeshFile pile_mesh(int quads) {
    MeshFile m;
    m.uvs = plane_mesh().uvs;
    for (int i = 0; i < quads; ++i) {
        const auto first = static_cast<std::uint32_t>(m.positions.size());
        for (const glm::dvec3& p : plane_mesh().positions) m.positions.push_back(p - glm::dvec3(0, 1e-3 * i, 0));
        const std::uint32_t turned = i % 2 == 0 ? 0 : 2;
        m.faces.push_back({{first + turned, first + 1, first + 2 - turned}, {turned, 1, 2 - turned}});
        m.faces.push_back({{first + turned, first + 2 - turned, first + 3}, {turned, 2 - turned, 3}});
    }
    return m;
}

TEST_P(Bundles, TheStackHoldsAllThatWaits) {
    const bool divided = GetParam() == "tessellated";  // into many boxes a quad
    Scene scene = make_scene(pile_mesh(divided ? 300 : 6000), 1e-4);
    const TestMap map = bumps(8);
    // Also from below, where the order is the other way round, and along the pile.
    for (const glm::dvec3& eye : {glm::dvec3(0.3, 2.2, 0.4), glm::dvec3(0.2, -8, 0.3), glm::dvec3(3, -3, 0.1)}) {
        scene.camera.eye = eye;
        scene.camera.look_at = {0, eye.x > 1 && !divided ? -3 : 0, 0};
        const auto depth = [&](vulkan::Context& context) {
            return make_renderer(scene, map, of_size(settings_of(scene), 24, 24), context).read_back(Layer::depth);
        };
        const auto together = depth(device());
        EXPECT_EQ(together, depth(lone_walkers()));
        EXPECT_TRUE(std::isfinite(together[24 * 12 + 12]));
    }
}

}  // namespace
}  // namespace relievo::test::bundles_test
