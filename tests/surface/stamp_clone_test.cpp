// Stamp and clone on a ball of six texture islands and on a strip whose halves differ in turn and scale.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "brushes/sculptor.h"
#include "brushes/tangent_frame.h"
#include "editor/session/surface/clone_source.h"
#include "editor/session/surface/mesh_surface.h"
#include "editor/session/surface/seam_gap.h"
#include "test_meshes.h"

namespace relievo::stamp_clone_test {
namespace {

using namespace test;

constexpr float kAmplitude = 0.2f;
constexpr auto kOne = static_cast<float>(Dab::kBarycentricOne);

struct Object {
    Object(Mesh the_mesh, int size)
        : mesh(std::move(the_mesh)),
          map(size, size),
          surface(mesh, displacement(double{kAmplitude}), map),
          sculptor(map, surface) {}

    FacePoint near(glm::dvec3 place) const { return surface.nearest_on_base(place); }
    SurfacePoint at(const FacePoint& p) const {
        return surface.at(p.face, static_cast<float>(p.b1) / kOne, static_cast<float>(p.b2) / kOne);
    }
    Dab dab(const FacePoint& p, std::array<std::int32_t, 3> drag = {}) const {
        return {.face = p.face, .b1 = p.b1, .b2 = p.b2, .drag = drag};
    }
    // Sets every texel by its place on the flat surface.
    template <typename Counts>
    void fill(Counts counts) {
        std::vector<SurfaceTexel> texels;
        surface.texels_in_ball(glm::vec3(0), 5, texels);
        for (const SurfaceTexel& t : texels)
            map.set(t.x, t.y, static_cast<std::uint16_t>(std::lround(counts(glm::dvec3(t.position)))));
        fill_gutters(map, surface.seams());
    }

    Mesh mesh;
    HeightMap map;
    MeshSurface surface;
    Sculptor sculptor;
};

Brush brush_of(Tool tool, float radius) {
    Brush brush;
    brush.tool = tool;
    brush.falloff = Falloff::constant;
    brush.radius = radius;
    brush.strength = 1;
    return brush;
}

std::shared_ptr<const Alpha> slopes() {
    std::vector<float> values;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            values.push_back(static_cast<float>(0.5 + 0.006 * (x - 31.5) - 0.004 * (y - 31.5)));
    return std::make_shared<const Alpha>("slopes", 64, 64, values);
}

TEST(StampOnIslands, acrossACornerOfThreeIslandsItFollowsOneClosedFormAndLeavesNoStep) {
    Object ball(box_sphere(8, 8, 8), 512);
    const FacePoint corner = ball.near(glm::normalize(glm::dvec3(1, 0.98, 0.97)));
    const SurfacePoint centre = ball.at(corner);
    std::vector<SurfaceTexel> texels;
    ball.surface.texels_in_ball(centre.position, 0.29f, texels);
    ASSERT_GT(texels.size(), 500u);
    Brush brush = brush_of(Tool::stamp, 0.3f);
    brush.strength = 0.4f;
    ball.sculptor.begin(brush, slopes());
    ball.sculptor.dab(ball.dab(corner, {20000, 40000, 30000}));
    ball.sculptor.end();
    const TangentFrame frame =
        tangent_frame(glm::dvec3(centre.base_normal), glm::dvec3(20000, 40000, 30000) / 65536.0);
    double largest = 0;
    for (const SurfaceTexel& t : texels) {
        const glm::dvec3 offset = (glm::dvec3(t.position) - glm::dvec3(centre.position)) / 0.3;
        const double value =
            0.5 + 0.006 * 32 * glm::dot(offset, frame.right) - 0.004 * 32 * glm::dot(offset, frame.up);
        largest =
            std::max(largest, std::abs(ball.map.at(t.x, t.y) - 32768 - value * 0.4 * 0.15 / 0.2 * 65535));
    }
    EXPECT_LE(largest, 1.0);
    EXPECT_EQ(max_seam_gap(ball.mesh, ball.map, Wrap::repeat, true), 0);
}

TEST(CloneOnIslands, onABallReliefGoesFromIslandToIslandTurnedWithTheSurface) {
    Object ball(box_sphere(32, 32, 32), 1024);
    const auto relief = [](glm::dvec3 p) {
        return 30000 + 5000 * std::sin(14 * p.y) * std::cos(12 * p.x) + 4000 * p.z;
    };
    ball.fill([&](glm::dvec3 p) { return p.z > 0.2 ? relief(p) : 20000.0; });
    const FacePoint from = ball.near({0.05, 0.1, 1}), to = ball.near({0.1, 0.98, -0.75});
    CloneSource source;
    source.set(from);
    source.begin(true);
    ball.sculptor.begin(brush_of(Tool::clone, 0.25f));
    for (int i = 0; i <= 5; ++i) {
        const FacePoint target = ball.near(glm::dvec3(ball.at(to).base) + 0.04 * i * glm::dvec3(1, 0.1, 0.1));
        const CloneSource::Place place = source.at(ball.surface, target);
        ball.sculptor.dab(ball.dab(target, place.turn), {}, std::span(&place.point, 1));
    }
    ball.sculptor.end();
    // On a ball the movement is a turn about its middle.
    const glm::dvec3 a(ball.at(to).base_normal), b(ball.at(from).base_normal), axis = glm::cross(a, b);
    const glm::dquat turn = glm::normalize(glm::dquat(1 + glm::dot(a, b), axis.x, axis.y, axis.z));
    std::vector<SurfaceTexel> texels;
    ball.surface.texels_in_ball(ball.at(to).position, 0.15f, texels);
    ASSERT_GT(texels.size(), 500u);
    double largest = 0;
    for (const SurfaceTexel& t : texels) {
        const double height = double{kAmplitude} * (ball.map.at(t.x, t.y) / 65535.0 - 0.5);
        const glm::dvec3 base = glm::dvec3(t.position) - height * glm::dvec3(t.normal);
        largest = std::max(largest, std::abs(ball.map.at(t.x, t.y) - relief(turn * base)));
    }
    EXPECT_LE(largest, 100) << "counts of 14,000, by the facets of 3 degrees; of 6, it is 320";
    EXPECT_EQ(max_seam_gap(ball.mesh, ball.map, Wrap::repeat, true), 0);
}

TEST(CloneOnIslands, fromACoarseIslandOfAnotherTurnToAFineOne) {
    Object strip(cut_strip(0.6, 0.5), 512);
    const auto relief = [](glm::dvec3 p) { return 30000 + 6000 * std::sin(9 * p.x) * std::cos(8 * p.y); };
    strip.fill([&](glm::dvec3 p) { return p.x > 1 ? relief(p) : 20000.0; });
    const FacePoint from = strip.near({1.53, 0.52, 0}), to = strip.near({0.5, 0.5, 0});
    CloneSource source;
    source.set(from);
    source.begin(true);
    strip.sculptor.begin(brush_of(Tool::clone, 0.2f));
    const CloneSource::Place place = source.at(strip.surface, to);
    EXPECT_EQ(place.turn, (std::array<std::int32_t, 3>{}));
    strip.sculptor.dab(strip.dab(to, place.turn), {}, std::span(&place.point, 1));
    strip.sculptor.end();
    std::vector<SurfaceTexel> texels;
    strip.surface.texels_in_ball(strip.at(to).position, 0.15f, texels);
    ASSERT_GT(texels.size(), 300u);
    const glm::dvec3 way = glm::dvec3(strip.at(from).base) - glm::dvec3(strip.at(to).base);
    double largest = 0;
    for (const SurfaceTexel& t : texels)
        largest = std::max(largest, std::abs(strip.map.at(t.x, t.y) -
                                             relief(glm::dvec3(t.position.x, t.position.y, 0) + way)));
    EXPECT_LE(largest, 40) << "counts of 12,000, linear between 64 texels a unit";
}

TEST(CloneSource, oppositeNormalsAndPlacesOffTheMeshStillHaveASource) {
    const Object ball(box_sphere(6, 6, 6), 256);
    CloneSource source;
    source.set(ball.near({0, 0, 1}));
    source.begin(true);
    const CloneSource::Place first = source.at(ball.surface, ball.near({0, 0, -1}));
    EXPECT_EQ(first.point, ball.near({0, 0, 1}));
    double length = 0;
    for (const std::int32_t part : first.turn) length += double{1.0 * part} * part;
    EXPECT_NEAR(std::sqrt(length), Dab::kDragOne, 2) << "half a turn";

    const Object sheet(plane(), 64);
    CloneSource beside;
    beside.set(sheet.near({0.9, 0.5, 0}));
    beside.begin(true);
    beside.at(sheet.surface, sheet.near({0.1, 0.5, 0}));
    const SurfacePoint off = sheet.at(beside.foreseen(sheet.surface, sheet.near({0.5, 0.5, 0})).point);
    EXPECT_NEAR(off.base.x, 1.0f, 1e-5f) << "the nearest point of the mesh";
}

// A third as wide along x as along y and z.
Mesh lens() {
    Mesh mesh = globe(48, 24);
    for (glm::vec3& p : mesh.positions) p.x /= 3;
    for (glm::vec3& n : mesh.normals) n = glm::normalize(n * glm::vec3(3, 1, 1));
    measure_bounds(mesh);
    return mesh;
}

// Processor seconds of one dab over the lens's broad side, the least of three; clone takes from its edge.
double seconds_of_dab(Tool tool) {
    double least = 1e9;
    for (int i = 0; i < 3; ++i) {
        Object object(lens(), 512);
        Brush brush;
        brush.tool = tool;
        brush.radius = 1;
        object.sculptor.begin(brush);
        const FacePoint target = object.near({0.33, 0, 0}), source = object.near({0, 0, 1});
        const std::vector<FacePoint> sources(tool == Tool::clone ? 1 : 0, source);
        const std::clock_t begun = std::clock();
        object.sculptor.dab(object.dab(target), {}, sources);
        least = std::min(least, static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC);
    }
    return least;
}

// Where the source's side ends, places have no texel near, and ask wider and wider around.
TEST(CloneSource, narrowerThanTheBrushTakesNoLongerThanOtherToolsThatResample) {
    EXPECT_LT(seconds_of_dab(Tool::clone), 3 * seconds_of_dab(Tool::pinch));
}

}  // namespace
}  // namespace relievo::stamp_clone_test
