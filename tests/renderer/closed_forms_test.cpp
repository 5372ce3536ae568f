// What every method promises in closed form; extreme scenes are met in tests/stability.
#include <gtest/gtest.h>

#include "tests/renderer/device.h"

namespace relievo::test::closed_forms_test {
namespace {

RELIEVO_EVERY_METHOD(ClosedForms);

TEST_P(ClosedForms, FlatMapsOnAPlaneLieWhereTheyShould) {
    for (const double value : {0.0, 0.5, 1.0}) {
        const Scene scene = make_scene(plane_mesh(), 0.4, 0.5);
        const TestMap map = make_map(16, 16, [&](double, double) { return value; });
        Renderer r = make_renderer(scene, map, settings_of(scene));
        const PickHit hit = r.pick(std::vector{Ray{{0.21f, 3, 0.1f}, {0, -1, 0}}})[0];
        ASSERT_TRUE(hit.hit);
        EXPECT_NEAR(hit.position.y, 0.4 * (value - 0.5), 1e-5);
        EXPECT_NEAR(hit.normal.y, 1, 1e-5);
    }
}

TEST_P(ClosedForms, RaysThroughEdgesAndVerticesHit) {
    const Scene scene = make_scene(ball_mesh(), 0.2);
    const TestMap map = make_map(32, 32, [](double, double) { return 0.7; });
    Renderer r = make_renderer(scene, map, settings_of(scene));
    const Mesh& mesh = scene.objects[0].mesh;
    std::vector<Ray> rays;
    for (const Mesh::Face& f : mesh.faces) {
        const glm::vec3 a = mesh.positions[f.position[0]], b = mesh.positions[f.position[1]];
        for (const glm::vec3& target : {a, (a + b) * 0.5f, a * 0.3f + b * 0.7f})
            rays.push_back({target * 4.0f, -target});
    }
    int missed = 0;
    for (const PickHit& h : r.pick(rays)) missed += h.hit && h.distance < 3.2f ? 0 : 1;
    EXPECT_EQ(missed, 0) << "of " << rays.size();
}

TEST(Settings, UnknownMethodAndBadParametersAreRefused) {
    const Scene scene = make_scene(plane_mesh(), 0.2);
    const TestMap map = bumps(16);
    RenderSettings s = settings_of(scene);
    s.method = "psychic";
    EXPECT_THROW(make_renderer(scene, map, s), std::invalid_argument);
    s.method = "pdm";
    s.parameters = {{"dt", -1.0}};
    EXPECT_THROW(make_renderer(scene, map, s), std::invalid_argument);
    s.parameters = {{"steps", 3.0}};
    EXPECT_THROW(make_renderer(scene, map, s), std::invalid_argument);
}

TEST(Settings, ImagesBeyondTheDevicesLargestBufferAreRefusedAndTheOldOneStays) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(device().physical_device(), &properties);
    const int side = static_cast<int>(properties.limits.maxImageDimension2D);
    if (properties.limits.maxStorageBufferRange / 16 >= static_cast<std::uint64_t>(side) * static_cast<std::uint64_t>(side))
        GTEST_SKIP() << "the device takes all images";
    const Scene scene = make_scene(plane_mesh(), 0.2);
    const TestMap map = bumps(16);
    RenderSettings s = settings_of(scene);
    Renderer r = make_renderer(scene, map, s);
    EXPECT_THROW(r.resize(side, side), std::invalid_argument);
    EXPECT_EQ(r.read_back(Layer::depth).size(), static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height));
    s.width = s.height = side;
    EXPECT_THROW(make_renderer(scene, map, s), std::invalid_argument);
}

}  // namespace
}  // namespace relievo::test::closed_forms_test
