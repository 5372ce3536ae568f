// Procedural heights on the device are those of the processor, by every method.
#include <algorithm>
#include <cmath>
#include <random>

#include "tests/procedural/exemplars.h"
#include "tests/renderer/device.h"

namespace relievo::test::procedural_test {
namespace {

RELIEVO_EVERY_METHOD(ProceduralHeights);

constexpr double kOneCount = 1.0 / 65535;

// Where rays go down on the plane [-1, 1]^2: anywhere, or, by a method that has the surface at its samples only, at these,
// which stand in `rows` rows.
std::vector<glm::vec2> places_on_plane(const Method& method, int rows) {
    std::vector<glm::vec2> places;
    if (method.geometry == GeometryKind::triangles) {
        for (int y = 1; y < rows; ++y)
            for (int x = 1; x < rows; ++x)
                places.push_back(glm::vec2(2 * x, 2 * y) / static_cast<float>(rows) - 1.0f);
        return places;
    }
    std::mt19937 random(2);
    std::uniform_real_distribution<float> place(-0.99f, 0.99f);
    for (int i = 0; i < 2000; ++i) {
        const float x = place(random);
        places.push_back({x, place(random)});
    }
    return places;
}

// Rays straight down: the plane's height is the source's.
double worst_height(const Exemplar& exemplar, const Procedural& settings, const std::string& method,
                    double uv_shift) {
    MeshFile plane = plane_mesh();
    for (glm::dvec2& uv : plane.uvs) uv += uv_shift;
    Scene scene = make_scene(plane, 1, 0);
    scene.objects[0].displacement.procedural = settings;
    RenderSettings render = settings_of(scene);
    render.method = method;
    if (method == "tessellated") render.parameters = {{"density", 1}};
    const HeightView view{exemplar.width, exemplar.height, exemplar.texels.data()};
    Renderer renderer(device(), scene, std::span(&view, 1), render);
    const ProceduralSource source = exemplar.source(settings);
    const double rows = std::ceil(std::max(exemplar.width, exemplar.height) * settings.scale);  // a texel each
    std::vector<Ray> rays;
    for (const glm::vec2& p : places_on_plane(find_method(method), static_cast<int>(rows)))
        rays.push_back({{p.x, 2, p.y}, {0, -1, 0}});
    EXPECT_GT(rays.size(), 50u);
    const std::vector<PickHit> hits = renderer.pick(rays);
    double worst = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const glm::dvec2 uv((rays[i].origin.x + 1.0) / 2 + uv_shift, (1.0 - rays[i].origin.z) / 2 + uv_shift);
        const double expected = source.value(source.texel_at(uv));
        worst = std::max(worst, hits[i].hit ? std::abs(2 - hits[i].distance - expected) : 1.0);
    }
    return worst;
}

TEST_P(ProceduralHeights, AreWithinOneCountOfTheProcessors) {
    // Every texel of the exemplar differs from its neighbours: another offset anywhere would show at once.
    const Exemplar noise = noise_exemplar(8, 12), rough = rough_exemplar(64, 64);
    EXPECT_LT(worst_height(noise, {{}, 1, {0, 0}, 0, 0.25}, GetParam(), 0), kOneCount);
    EXPECT_LT(worst_height(rough, {{}, 2.5, {0.3, -0.7}, 77, 0.25}, GetParam(), 0), kOneCount);
    EXPECT_LT(worst_height(rough, {{}, 0.5, {-300, 900}, 2147483647, 0.11}, GetParam(), 0), kOneCount);
}

TEST_P(ProceduralHeights, StayTheSameFarFromTheOrigin) {
    const Exemplar rough = rough_exemplar(64, 64);
    EXPECT_LT(worst_height(rough, {{}, 1, {0, 0}, 3, 0.25}, GetParam(), -4096), kOneCount);
}

TEST_P(ProceduralHeights, OfASingleTexelAreFlat) {
    const Exemplar one = constant_exemplar(1, 1, 30000);
    EXPECT_LT(worst_height(one, {{}, 10, {0, 0}, 3, 0.25}, GetParam(), 0), kOneCount);
}

TEST(ProceduralScenes, MixWithMapsAndKeepTheirPlaces) {
    Scene scene = make_scene(plane_mesh(), 0.3);
    scene.objects.push_back(scene.objects[0]);
    scene.objects[1].displacement.procedural = Procedural{};
    for (glm::vec3& p : scene.objects[1].mesh.positions) p.y -= 3;
    measure_bounds(scene.objects[1].mesh);
    const TestMap map = make_map(4, 4, [](double, double) { return 1.0; });
    const Exemplar exemplar = constant_exemplar(3, 3, 0);
    const std::vector<HeightView> views{map.view(), {3, 3, exemplar.texels.data()}};
    Renderer renderer(device(), scene, views, settings_of(scene));
    const std::vector<PickHit> hits =
        renderer.pick(std::vector<Ray>{{{0.2f, 2, 0.3f}, {0, -1, 0}}, {{0.2f, -1, 0.3f}, {0, -1, 0}}});
    EXPECT_NEAR(hits[0].position.y, 0.15, 1e-5);
    EXPECT_NEAR(hits[1].position.y, -3.15, 1e-5);
}

TEST_P(ProceduralHeights, LookTheSameWithEverythingOn) {
    Scene scene = make_scene(ball_mesh(), 0.3);
    scene.objects[0].displacement.procedural = Procedural{};
    const Exemplar exemplar = rough_exemplar(64, 64);
    const HeightView view{64, 64, exemplar.texels.data()};
    std::vector<float> images[2];
    for (const bool everything : {false, true}) {
        RenderSettings settings = settings_of(scene);
        settings.everything = everything;
        Renderer renderer(device(), scene, std::span(&view, 1), settings);
        renderer.render();
        images[everything ? 1 : 0] = renderer.read_back(Layer::beauty);
    }
    EXPECT_TRUE(same_image(images[0], images[1]));
}

TEST(ProceduralScenes, FollowTheirSettings) {
    Scene scene = make_scene(plane_mesh(), 0.3);
    scene.objects[0].displacement.procedural = Procedural{};
    const Exemplar exemplar = rough_exemplar(64, 64);
    const HeightView view{64, 64, exemplar.texels.data()};
    Renderer renderer(device(), scene, std::span(&view, 1), settings_of(scene));
    const std::vector<float> before = renderer.read_back(Layer::depth);
    const Procedural other{{}, 3, {1, 2}, 5, 0.4};
    Displacement changed = scene.objects[0].displacement;
    changed.procedural = other;
    renderer.set_heights(0, changed, view);
    const std::vector<float> after = renderer.read_back(Layer::depth);
    EXPECT_NE(before, after);
    scene.objects[0].displacement.procedural = other;
    Renderer fresh(device(), scene, std::span(&view, 1), settings_of(scene));
    EXPECT_EQ(after, fresh.read_back(Layer::depth));
    // And back to a map.
    changed.procedural.reset();
    const TestMap map = bumps(32);
    renderer.set_heights(0, changed, map.view());
    scene.objects[0].displacement = changed;
    EXPECT_EQ(renderer.read_back(Layer::depth), depth_of(scene, map, settings_of(scene)));
}

}  // namespace
}  // namespace relievo::test::procedural_test
