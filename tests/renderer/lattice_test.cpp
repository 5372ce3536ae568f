// The walk of dbvh through a procedural source's lattice: no holes at any range, and S itself as the range
// grows.
#include <algorithm>
#include <cstdio>
#include <random>

#include "tests/procedural/exemplars.h"
#include "tests/renderer/device.h"

namespace relievo::test::lattice_test {
namespace {

constexpr double kAmplitude = 0.2;

// Procedural heights have no period: around a ball they would tear at its seam. Seen from above they do not.
MeshFile ball_seen_from_above() {
    MeshFile ball = ball_mesh();
    ball.uvs.clear();
    for (const auto& p : ball.positions) ball.uvs.push_back({0.5 + 0.45 * p.x, 0.5 + 0.45 * p.z});
    for (auto& face : ball.faces) face.uv = face.position;
    return ball;
}

struct ProceduralBall {
    ProceduralBall()
        : scene(make_scene(ball_seen_from_above(), kAmplitude)), exemplar(rough_exemplar(128, 128)) {
        scene.objects[0].displacement.procedural = Procedural{{}, 2, {0.3, -0.1}, 9, 0.25};
    }
    Renderer renderer(const std::string& method, const std::map<std::string, double>& parameters) const {
        const HeightView view{exemplar.width, exemplar.height, exemplar.texels.data()};
        RenderSettings settings = settings_of(scene);
        settings.method = method;
        settings.parameters = parameters;
        return Renderer(device(), scene, std::span(&view, 1), settings);
    }
    Scene scene;
    Exemplar exemplar;
};

// Depth errors in units of the amplitude, of what both see.
struct Errors {
    double median = 0, p90 = 0;
    int missed = 0, invented = 0;
};

Errors errors_of(const std::vector<float>& depth, const std::vector<float>& exact) {
    Errors result;
    std::vector<double> errors;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        const bool hit = std::isfinite(depth[i]), there = std::isfinite(exact[i]);
        result.missed += there && !hit;
        result.invented += hit && !there;
        if (hit && there) errors.push_back(std::abs(double{depth[i]} - double{exact[i]}) / kAmplitude);
    }
    std::sort(errors.begin(), errors.end());
    result.median = errors[errors.size() / 2];
    result.p90 = errors[errors.size() * 9 / 10];
    return result;
}

TEST(LatticeWalk, NearsTheSurfaceAsTheRangeGrows) {
    const ProceduralBall ball;
    const std::vector<float> exact = ball.renderer("exact", {}).read_back(Layer::depth);
    Renderer renderer = ball.renderer("dbvh", {});
    const Errors own_texels = errors_of(renderer.read_back(Layer::depth), exact);
    EXPECT_LT(own_texels.median, 1e-5);
    EXPECT_EQ(own_texels.missed, 0);
    double last = 1;
    for (const double range : {8.0, 64.0, 512.0}) {
        renderer.set_method("dbvh", {{"range", range}});
        const Errors e = errors_of(renderer.read_back(Layer::depth), exact);
        std::printf("range %g: median %.2g, p90 %.2g, %d missed, %d invented\n", range, e.median, e.p90,
                    e.missed, e.invented);
        EXPECT_LT(e.median, 0.7 * last);
        last = e.median;
    }
    EXPECT_LT(last, 2e-3);  // parts of a sixteenth of a texel
}

TEST(LatticeWalk, NoRayPassesAClosedMesh) {
    const ProceduralBall ball;
    const Mesh& mesh = ball.scene.objects[0].mesh;
    std::vector<Ray> rays;
    const auto aim = [&](const glm::vec3& target, const glm::vec3& from) {
        rays.push_back({from, glm::normalize(target - from)});
    };
    for (const Mesh::Face& f : mesh.faces) {
        const glm::vec3 a = mesh.positions[f.position[0]], b = mesh.positions[f.position[1]];
        for (const glm::vec3& target : {a, (a + b) * 0.5f, a * 0.3f + b * 0.7f}) {
            aim(glm::vec3(0), target * 4.0f);
            aim(target * 0.4f, target * 4.0f + glm::vec3(0.5f, 1, -0.7f));
        }
    }
    std::mt19937 random(4);
    std::normal_distribution<float> normal;
    for (int i = 0; i < 10000; ++i)
        aim(0.5f * glm::normalize(glm::vec3(normal(random), normal(random), normal(random))),
            3.0f * glm::normalize(glm::vec3(normal(random), normal(random), normal(random))));
    Renderer renderer = ball.renderer("dbvh", {{"range", 8}});
    for (const double range : {8.0, 64.0, 512.0}) {
        for (const double leaf : {0.0, 2.0}) {
            renderer.set_method("dbvh", {{"range", range}, {"leaf", leaf}});
            int passed = 0;
            // A ray that meets the near side is at least 0.8 from the middle when it does.
            const std::vector<PickHit> hits = renderer.pick(rays);
            for (std::size_t i = 0; i < hits.size(); ++i) {
                const float middle = -glm::dot(rays[i].origin, rays[i].direction);
                passed += hits[i].hit && hits[i].distance < middle ? 0 : 1;
            }
            EXPECT_EQ(passed, 0) << "of " << rays.size() << ", range " << range << ", leaf " << leaf;
        }
    }
}

}  // namespace
}  // namespace relievo::test::lattice_test
