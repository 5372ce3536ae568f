// Extreme scenes: every pixel finite, every frame done, no message of the layers (DESIGN.md section 8).
#include <gtest/gtest.h>

#include "tests/renderer/device.h"

namespace relievo::test {
namespace {

struct Case {
    const char* name;
    Scene scene;
    TestMap map;
};

MeshFile scaled(MeshFile m, const glm::dvec3& scale, const glm::dvec3& shift = {}) {
    for (auto& p : m.positions) p = p * scale + shift;
    m.file_normals.clear();
    return m;
}

Scene seen(Scene scene, double size, const glm::dvec3& centre = {}) {
    scene.camera.eye = centre + glm::dvec3(0.7, 2.2, 2.6) * size;
    scene.camera.look_at = centre;
    return scene;
}

Scene rebased(const MeshFile& file, double amplitude, const glm::dvec3& origin) {
    Scene scene = make_scene(file, amplitude);
    scene.origin = origin;
    scene.objects[0].mesh = make_mesh(file, glm::dmat4(1), origin, false);
    return seen(scene, 1, origin);
}

MeshFile folded_wedge() {
    MeshFile m = plane_mesh();
    m.positions[3] = {0.9, 0.02, 0.98};  // the second triangle lies almost on the back of the first
    return m;
}

MeshFile wild_uvs() {
    MeshFile m = plane_mesh();
    m.uvs = {{-70.5, 3}, {1e4, 0.25}, {0.5, -900}, {0.5, 0.5}};
    return m;
}

MeshFile with_zero_area() {
    MeshFile m = plane_mesh();
    m.faces.push_back({{0, 0, 1}, {0, 0, 1}});
    m.faces.push_back({{0, 1, 1}, {0, 2, 2}});
    return m;
}

std::vector<Case> cases() {
    const TestMap cliffs = make_map(64, 64, [](double u, double v) {
        return (int(u * 16) + int(v * 16)) % 2 == 0 ? 0.0 : 1.0;
    });
    std::vector<Case> list;
    const auto add = [&](const char* name, const Scene& scene, const TestMap& map) { list.push_back({name, scene, map}); };
    add("cliffs", make_scene(plane_mesh(), 0.5), cliffs);
    add("one texel", make_scene(ball_mesh(), 0.3), make_map(1, 1, [](double, double) { return 0.8; }));
    add("one by nine", make_scene(ball_mesh(), 0.3), make_map(1, 9, [](double, double v) { return v; }));
    add("flat at zero", make_scene(ball_mesh(), 0.3), make_map(8, 8, [](double, double) { return 0.0; }));
    add("flat at one", make_scene(ball_mesh(), 0.3), make_map(8, 8, [](double, double) { return 1.0; }));
    add("amplitude zero", make_scene(ball_mesh(), 0), bumps(64));
    add("amplitude tiny", make_scene(ball_mesh(), 1e-6), bumps(64));
    add("amplitude ten edges", make_scene(ball_mesh(), 2), bumps(64));
    add("amplitude minus ten edges", make_scene(ball_mesh(), -2), bumps(64));
    for (const Wrap wrap : {Wrap::clamp, Wrap::repeat}) {
        Scene wild = make_scene(wild_uvs(), 0.2, 0.5, wrap);
        wild.image = {32, 32, 4};  // a ray crosses half a million texels
        add(wrap == Wrap::clamp ? "clamp wrap, uv outside" : "repeat wrap, uv outside", wild, bumps(64));
    }
    add("sliver", seen(make_scene(scaled(plane_mesh(), {1, 1, 1e-4}), 0.2), 1), bumps(64));
    add("folded wedge", make_scene(folded_wedge(), 0.3), bumps(64));
    add("zero-area faces", make_scene(with_zero_area(), 0.2), bumps(64));
    add("scale 1e-4", seen(make_scene(scaled(ball_mesh(), glm::dvec3(1e-4)), 3e-5), 1e-4), bumps(64));
    add("scale 1e4", seen(make_scene(scaled(ball_mesh(), glm::dvec3(1e4)), 3e3), 1e4), bumps(64));
    add("1e5 away", rebased(scaled(ball_mesh(), glm::dvec3(1), glm::dvec3(1e5)), 0.3, glm::dvec3(1e5)), bumps(64));
    Scene inside = make_scene(ball_mesh(), 0.2);
    inside.camera.eye = {0.01, 0.02, 0.03};
    add("from inside", inside, bumps(64));
    Scene below = make_scene(plane_mesh(), 0.2);
    below.camera.eye = {0.3, -2, 0.4};
    add("from below", below, bumps(64));
    Scene along = make_scene(plane_mesh(), 0.2);
    along.camera.eye = {3, 0, 0};
    add("along the surface", along, bumps(64));
    return list;
}

RELIEVO_EVERY_METHOD(Extremes);

TEST_P(Extremes, EveryPixelIsFiniteAndSomethingIsSeen) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        Renderer r = make_renderer(c.scene, c.map, settings_of(c.scene));
        r.render();
        for (const float v : r.read_back(Layer::beauty)) ASSERT_TRUE(std::isfinite(v));
        for (const Layer layer : {Layer::normal, Layer::shading_normal, Layer::uv})
            for (const float v : r.read_back(layer)) ASSERT_TRUE(std::isfinite(v));
        int hits = 0;
        for (const float z : r.read_back(Layer::depth)) {
            ASSERT_FALSE(std::isnan(z));
            ASSERT_GE(z, 0);
            hits += std::isfinite(z) ? 1 : 0;
        }
        const bool may_be_unseen = std::string(c.name) == "sliver";
        EXPECT_TRUE(hits > 100 || may_be_unseen) << hits << " pixels hit";
    }
}

TEST_P(Extremes, FlatMapsOnAPlaneLieWhereTheyShould) {
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

TEST_P(Extremes, RaysThroughEdgesAndVerticesHit) {
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

}  // namespace
}  // namespace relievo::test
