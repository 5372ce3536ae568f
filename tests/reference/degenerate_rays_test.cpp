// Rays along the surface, through edges and vertices, from inside and below, and from far away.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "tests/reference/sample_surfaces.h"

namespace relievo::test::degenerate_rays_test {
namespace {

using glm::dvec3;

constexpr double kFar = 1e30;

SampleSurface ball_with_dunes(int columns, int rows, double amplitude, double midlevel) {
    SampleSurface sample;
    sample.mesh = ball_mesh(columns, rows);
    sample.amplitude = amplitude;
    sample.midlevel = midlevel;
    sample.paint(96, 48, [](int x, int y) { return ball_dunes((x + 0.5) / 96, (y + 0.5) / 48); });
    return sample;
}

TEST(DegenerateRays, ThroughEveryVertexAndEdgeOfABallTheyHit) {
    const SampleSurface sample = ball_with_dunes(12, 7, 0.2, 0.5);
    const ReferenceSurface surface = sample.reference();
    const Mesh& mesh = sample.mesh;
    for (const Mesh::Face& face : mesh.faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (face.position[i] < 2 || face.position[(i + 1) % 3] < 2)
                continue;  // the fans at the poles are torn
            const dvec3 a = mesh.positions[face.position[i]], b = mesh.positions[face.position[(i + 1) % 3]];
            for (int k = 0; k <= 8; ++k) {
                // P and N on the edge both point away from 0 there: S stands over the edge, seen along it.
                const dvec3 on = a + (b - a) * (k / 8.0);
                const auto outer = surface.first_hit(on * 5.0, -on, 0, kFar);
                const auto inner = surface.first_hit(dvec3(0), on, 0, kFar);
                ASSERT_TRUE(outer && inner) << k;
                EXPECT_NEAR(5 - outer->t, inner->t, 1e-6);  // normals are float
            }
        }
    }
}

TEST(DegenerateRays, ThroughTheVerticesAndDiagonalOfAPlaneTheyHit) {
    SampleSurface sample;
    sample.mesh = plane_mesh();
    sample.amplitude = 0.1;
    sample.paint(8, 8, [](int x, int y) {
        return hash01(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 4);
    });
    const ReferenceSurface surface = sample.reference();
    for (int i = 0; i <= 1000; ++i) {
        const double s = i / 1000.0;
        EXPECT_TRUE(surface.first_hit({s, s, 1}, {0, 0, -1}, 0, kFar)) << s;
        EXPECT_TRUE(surface.first_hit({s, 0, 1}, {0, 0, -1}, 0, kFar)) << s;
        EXPECT_TRUE(surface.first_hit({1, s, 1}, {0, 0, -1}, 0, kFar)) << s;
    }
}

TEST(DegenerateRays, LyingInAFlatSurfaceTheyHitAtItsBorder) {
    SampleSurface sample;
    sample.mesh = plane_mesh();
    sample.amplitude = 1;
    sample.midlevel = 0.5;
    sample.texels = {0};
    const ReferenceSurface surface = sample.reference();
    const auto hit = surface.first_hit({-1, 0.3, -0.5}, {1, 0, 0}, 0, kFar);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 1, 1e-12);
    const auto diagonal = surface.first_hit({-1, -1, -0.5}, glm::normalize(dvec3(1, 1, 0)), 0, kFar);
    ASSERT_TRUE(diagonal);
    EXPECT_NEAR(diagonal->t, std::sqrt(2.0), 1e-12);
    const auto inside = surface.first_hit({0.2, 0.3, -0.5}, {1, 0, 0}, 0, kFar);
    ASSERT_TRUE(inside);
    EXPECT_NEAR(inside->t, 0, 1e-12);
}

TEST(DegenerateRays, LyingInARulingOfABilinearCellTheyEnd) {
    // z = x'y' holds the straight line y' = 0.5, z = 0.5 x'.
    SampleSurface sample;
    sample.mesh = plane_mesh();
    sample.amplitude = 1;
    sample.wrap = Wrap::clamp;
    sample.paint(2, 2, [](int x, int y) { return x * y; });
    const ReferenceSurface surface = sample.reference();
    const dvec3 on(0.3, 0.5, 0.05);
    const auto answer = surface.trace(on, {0.5, 0, 0.5}, 0, kFar);
    EXPECT_FALSE(answer.undecided);
    ASSERT_TRUE(answer.hit);
    EXPECT_LT(answer.hit->t, 1e-6);
    EXPECT_LT(answer.nodes, 5000u);
}

TEST(DegenerateRays, OnAnEdgeThatRunsThroughTexelCornersTheyEnd) {
    // The diagonal of the plane runs through the corners of texel cells: cut there, parts without any width
    // remain.
    SampleSurface sample;
    sample.mesh = plane_mesh();
    sample.amplitude = 0.5;
    sample.wrap = Wrap::clamp;
    sample.paint(8, 8, [](int x, int y) { return (x + y) % 2; });
    const ReferenceSurface surface = sample.reference();
    std::uint64_t most = 0;
    for (int i = 0; i <= 32; ++i) {
        const double s = i / 32.0;
        const auto down = surface.trace({s, s, 2}, {0, 0, -1}, 0, kFar);
        EXPECT_TRUE(down.hit) << s;
        most = std::max(most, down.nodes);
        for (const double z : {0.0, 0.125, 0.25, 0.5}) {
            const auto along = surface.trace({s, s, z}, glm::normalize(dvec3(1, 1, 0)), 0, kFar);
            EXPECT_FALSE(along.undecided);
            most = std::max(most, along.nodes);
        }
    }
    EXPECT_LT(most, 20000u);
}

TEST(DegenerateRays, TangentRaysEndWithinTheNodeLimit) {
    const SampleSurface sample = ball_with_dunes(32, 16, 0.2, 0.5);
    const ReferenceSurface surface = sample.reference();
    std::uint64_t most = 0;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        // Along the surface, in its tangent plane at a random place.
        const std::uint32_t face =
            static_cast<std::uint32_t>(hash01(i, 0, 6) * static_cast<double>(sample.mesh.faces.size()));
        const double b1 = hash01(i, 1, 6), b2 = (1 - b1) * hash01(i, 2, 6);
        const ReferencePoint point = surface.evaluate(0, face, b1, b2);
        const dvec3 along = glm::normalize(glm::cross(point.normal, dvec3(0.3, -0.5, 0.8)));
        const auto answer = surface.trace(point.position - along * 3.0, along, 0, kFar);
        EXPECT_FALSE(answer.undecided);
        if (answer.hit) {
            EXPECT_LE(answer.hit->t, 3 + 1e-5);
        }
        most = std::max(most, answer.nodes);
    }
    EXPECT_LT(most, 20000u);
}

TEST(DegenerateRays, FromInsideAndFromBelowTheyHitTheBackOfTheSurface) {
    const SampleSurface sample = ball_with_dunes(32, 16, 0.3, 0.2);
    const ReferenceSurface surface = sample.reference();
    for (std::uint32_t i = 0; i < 500; ++i) {
        const dvec3 d = glm::normalize(dvec3(hash01(i, 0, 1), hash01(i, 1, 1), hash01(i, 2, 1)) - 0.5);
        const auto hit = surface.first_hit(dvec3(0), d, 0, kFar);
        ASSERT_TRUE(hit) << i;
        // N points along P within float's rounding: the height over the ball is what the map says.
        EXPECT_NEAR(glm::dot(hit->position, d), hit->t, 1e-13);
        const ReferencePoint again = surface.evaluate(0, hit->face, hit->b1, hit->b2);
        EXPECT_NEAR(glm::distance(again.position, hit->position), 0, 1e-13);
        EXPECT_GT(glm::dot(hit->normal, d), 0);
        // t_min just behind the hit: the ray leaves the star-shaped ball for good.
        EXPECT_FALSE(surface.first_hit(dvec3(0), d, hit->t + 1e-9, kFar));
        EXPECT_FALSE(surface.first_hit(dvec3(0), d, 0, hit->t - 1e-9));
    }
}

TEST(DegenerateRays, FromAMillionUnitsAwayTheyHitWithinTheRoundingOfTheirOwnNumbers) {
    const SampleSurface sample = ball_with_dunes(32, 16, 0.2, 0.5);
    const ReferenceSurface surface = sample.reference();
    const dvec3 near_eye(0.3, 2, 0.4), d = glm::normalize(dvec3(0.02, -1, 0.05));
    const auto near_hit = surface.first_hit(near_eye, d, 0, kFar);
    const auto far_hit = surface.first_hit(near_eye - d * 1e6, d, 0, kFar);
    ASSERT_TRUE(near_hit && far_hit);
    EXPECT_NEAR(far_hit->t - 1e6, near_hit->t, 1e-8);
}

TEST(DegenerateRays, AtScalesFromTenThousandthToTenThousandTheyHitTheSamePlaces) {
    const SampleSurface unit = ball_with_dunes(32, 16, 0.25, 0.5);
    const ReferenceSurface surface = unit.reference();
    for (const double scale : {0x1p-14, 0x1p14}) {  // powers of two: the float positions scale exactly
        SampleSurface scaled = unit;
        for (glm::vec3& p : scaled.mesh.positions) p *= static_cast<float>(scale);
        scaled.amplitude *= scale;
        const ReferenceSurface other = scaled.reference();
        for (std::uint32_t i = 0; i < 300; ++i) {
            const dvec3 from = (dvec3(hash01(i, 0, 4), hash01(i, 1, 4), hash01(i, 2, 4)) - 0.5) * 6.0;
            const dvec3 d = (dvec3(hash01(i, 3, 4), hash01(i, 4, 4), hash01(i, 5, 4)) - 0.5) - from;
            const auto a = surface.first_hit(from, d, 0, kFar),
                       b = other.first_hit(from * scale, d * scale, 0, kFar);
            ASSERT_EQ(a.has_value(), b.has_value()) << scale << " " << i;
            if (!a) continue;
            EXPECT_NEAR(a->t, b->t, 1e-12) << scale << " " << i;
            EXPECT_EQ(a->face, b->face) << scale << " " << i;
        }
    }
}

TEST(Images, AreTheSameWithAnyNumberOfThreads) {
    const SampleSurface sample = ball_with_dunes(32, 16, 0.25, 0.5);
    const ReferenceSurface surface = sample.reference();
    int rows = 0;
    const ReferenceImage one =
        trace_image(surface, Camera{}, dvec3(0), 24, 16, 1, [&](int done) { rows = done; });
    const ReferenceImage three = trace_image(surface, Camera{}, dvec3(0), 24, 16, 3);
    EXPECT_EQ(rows, 16);
    EXPECT_EQ(one.depth, three.depth);
    EXPECT_EQ(one.normal, three.normal);
    EXPECT_EQ(one.uv, three.uv);
    EXPECT_EQ(one.face, three.face);
}

TEST(DegenerateRays, DirectionNeedNotBeUnit) {
    const SampleSurface sample = ball_with_dunes(12, 7, 0.2, 0.5);
    const ReferenceSurface surface = sample.reference();
    const dvec3 from(0.1, 3, 0.2), d(0.01, -1, 0.02);
    const auto one = surface.first_hit(from, d, 0, kFar);
    for (const double scale : {1e-12, 0.3, 1e12}) {
        const auto other = surface.first_hit(from, d * scale, 0, kFar);
        ASSERT_TRUE(one && other);
        EXPECT_NEAR(other->t * scale, one->t, 1e-12);
    }
    EXPECT_THROW(surface.trace(from, dvec3(0), 0, 1), std::invalid_argument);
    EXPECT_THROW(surface.trace(from, {0, std::numeric_limits<double>::quiet_NaN(), 1}, 0, 1),
                 std::invalid_argument);
}

TEST(DegenerateMeshes, ZeroAreaFacesSliversAndVanishingNormalsNeitherHangNorHit) {
    SampleSurface sample;
    sample.amplitude = 0.3;
    sample.paint(16, 16, [](int x, int y) {
        return hash01(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 8);
    });
    // Normals that cancel inside the face.
    sample.mesh = triangle_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0.1, -1}, {0.1, 0, 1});
    const ReferenceSurface torn = sample.reference();
    for (std::uint32_t i = 0; i < 300; ++i) {
        const auto answer =
            torn.trace({hash01(i, 0, 1), hash01(i, 1, 1), 2}, {hash01(i, 2, 1) - 0.5, 0.1, -2}, 0, kFar);
        EXPECT_FALSE(answer.undecided);
    }
    sample.mesh = triangle_mesh({0, 0, 0}, {1, 0, 0}, {0.5, 1e-4, 0}, {0, 0, 1}, {0, 0.3, 1}, {0.1, 0, 1});
    const ReferenceSurface sliver = sample.reference();
    const ReferencePoint on = sliver.evaluate(0, 0, 0.3, 0.3);
    const auto hit = sliver.first_hit(on.position + dvec3(0, 0, 2), {0, 0, -1}, 0, kFar);
    ASSERT_TRUE(hit);
    EXPECT_LE(hit->t, 2 + 1e-9);
    sample.mesh = triangle_mesh({0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1});
    EXPECT_FALSE(sample.reference().first_hit({0.3, 0, 1}, {0, 0, -1}, 0, kFar));
}

TEST(NodeLimit, AnswersUndecidedInsteadOfHanging) {
    const SampleSurface sample = ball_with_dunes(32, 16, 0.2, 0.5);
    const ReferenceObject object = sample.object();
    const ReferenceSurface surface({&object, 1}, 3);
    EXPECT_TRUE(surface.trace({0, -3, 0.1}, {0, 1, 0}, 0, kFar).undecided);
}

}  // namespace
}  // namespace relievo::test::degenerate_rays_test
