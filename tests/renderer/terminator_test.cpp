// Where light grazes a coarse mesh, its triangles do not show: shadows end where the curved surface that the vertex normals
// tell of turns from the light. Relief keeps its shadows.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/renderer/device.h"

namespace relievo::test::terminator_test {
namespace {

constexpr float kIrradiance = 3, kAlbedo = 0.6f;
const glm::dvec3 kSunTravels = glm::normalize(glm::dvec3(-1, -0.15, 0.4));
const glm::vec3 kToSun(-kSunTravels);

// A ball of 120 triangles under a sun alone, of the smallest size.
Scene coarse_ball(double amplitude) {
    Scene scene = make_scene(ball_mesh(12, 6), amplitude);
    scene.lights.front().direction = kSunTravels;
    scene.lights.front().intensity = kIrradiance;
    scene.lights.front().angle_deg = 0;
    scene.environment.intensity = 0;
    scene.objects.front().material.albedo = glm::vec3(kAlbedo);
    scene.objects.front().material.specular = 0;
    return scene;
}

TEST(Terminator, OfACoarseBallIsThatOfARoundOne) {
    for (const double value : {0.5, 0.9}) {
        const Scene scene = coarse_ball(0.3);
        const TestMap map = make_map(16, 16, [&](double, double) { return value; });
        Renderer r = make_renderer(scene, map, settings_of(scene));
        r.render();
        const std::vector<float> beauty = r.read_back(Layer::beauty), normals = r.read_back(Layer::shading_normal),
                                 depth = r.read_back(Layer::depth);
        int grazed = 0, wrong = 0;
        for (std::size_t i = 0; i < depth.size(); ++i) {
            const glm::vec3 n(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]);
            const float cosine = glm::dot(n, kToSun);
            if (!(depth[i] < 1e9f) || glm::length(n) < 0.5f || std::abs(cosine) < 0.04f || std::abs(cosine) > 0.5f) continue;
            ++grazed;
            const float expected = std::max(cosine, 0.0f) * kIrradiance * kAlbedo / 3.14159265f;
            if (std::abs(beauty[4 * i] - expected) > 0.02f) ++wrong;
        }
        EXPECT_GT(grazed, 400);
        EXPECT_LE(wrong, grazed / 100) << "of " << grazed;
    }
}

TEST(Terminator, LeavesShadowsOnAllTrianglesThatTheLightReaches) {
    const Scene scene = coarse_ball(0.3);
    const TestMap map = bumps(64);
    Renderer r = make_renderer(scene, map, settings_of(scene));
    r.render();
    const std::vector<float> beauty = r.read_back(Layer::beauty), shading = r.read_back(Layer::shading_normal);
    std::vector<Ray> camera, shadow;
    for (int y = 0; y < r.height(); ++y)
        for (int x = 0; x < r.width(); ++x) camera.push_back(r.camera_ray(x + 0.5, y + 0.5));
    const std::vector<PickHit> hits = r.pick(camera);
    for (const PickHit& hit : hits) shadow.push_back({hit.position + hit.normal * 2e-4f, kToSun});
    const std::vector<PickHit> blocked = r.pick(shadow);
    const Mesh& mesh = scene.objects.front().mesh;
    int shadowed = 0, wrong = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const glm::vec3 n(shading[3 * i], shading[3 * i + 1], shading[3 * i + 2]);
        if (!hits[i].hit || glm::dot(hits[i].normal, kToSun) < 0.05f || glm::dot(n, kToSun) < 0.05f) continue;
        if (glm::dot(hits[i].normal, camera[i].direction) > 0) continue;  // from inside, where the map's ends do not meet
        const auto& corners = mesh.faces[hits[i].face].position;
        const glm::vec3 a = mesh.positions[corners[0]], b = mesh.positions[corners[1]], c = mesh.positions[corners[2]];
        if (glm::dot(glm::normalize(glm::cross(b - a, c - a)), kToSun) < 0.05f) continue;
        if (blocked[i].hit) ++shadowed;
        if (blocked[i].hit != (beauty[4 * i] == 0)) ++wrong;
    }
    EXPECT_GT(shadowed, 30);
    EXPECT_LE(wrong, 2) << "of " << shadowed;
}

}  // namespace
}  // namespace relievo::test::terminator_test
