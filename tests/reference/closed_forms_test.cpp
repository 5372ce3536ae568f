// Surfaces whose intersections are known in closed form.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/reference/sample_surfaces.h"

namespace relievo::test::closed_forms_test {
namespace {

using glm::dvec3;

constexpr double kFar = 1e30;

SampleSurface plane_with(int w, int h, const std::function<double(int, int)>& value, double amplitude,
                         double midlevel, Wrap wrap = Wrap::clamp) {
    SampleSurface sample;
    sample.mesh = plane_mesh();
    sample.amplitude = amplitude;
    sample.midlevel = midlevel;
    sample.wrap = wrap;
    sample.paint(w, h, value);
    return sample;
}

TEST(Plane, FlatMapsAtBothLimitsAndAtMidlevelLieWhereTheyShould) {
    for (const double value : {0.0, 0.5, 1.0}) {
        for (const double amplitude : {0.0, 1e-6, 0.3, -0.7, 100.0}) {
            for (const int size : {1, 3, 64}) {
                const SampleSurface sample = plane_with(
                    size, size, [&](int, int) { return value; }, amplitude, 0.25);
                const ReferenceSurface surface = sample.reference();
                const double height = amplitude * (sample.texels[0] / 65535.0 - 0.25);
                const dvec3 from(0.3, 0.4, 200), to(0.6, 0.7, height);
                const auto hit = surface.first_hit(from, to - from, 0, kFar);
                ASSERT_TRUE(hit) << value << " " << amplitude << " " << size;
                EXPECT_NEAR(hit->t, 1, 1e-14);
                EXPECT_NEAR(hit->position.x, 0.6, 1e-13);
                EXPECT_NEAR(hit->position.y, 0.7, 1e-13);
                EXPECT_NEAR(glm::distance(hit->normal, dvec3(0, 0, 1)), 0, 1e-14);
            }
        }
    }
}

TEST(Plane, RampIsASlantedPlane) {
    // Between the centres of 17 texels, value = i/16: z = A ((17 x - 0.5)/16 - mid), seen from above and from
    // below.
    const SampleSurface sample = plane_with(
        17, 5, [](int x, int) { return x / 16.0; }, 2.0, 0.25);
    const ReferenceSurface surface = sample.reference();
    const auto z = [](double x) { return 2 * ((17 * x - 0.5) / 16 - 0.25); };
    for (int i = 0; i < 200; ++i) {
        const auto n = static_cast<std::uint32_t>(i);
        const double x = 0.05 + 0.9 * hash01(n, 0, 3), y = 0.02 + 0.96 * hash01(n, 1, 3);
        const dvec3 on(x, y, z(x));
        const dvec3 across(hash01(n, 2, 3) - 0.5, hash01(n, 3, 3) - 0.5, i % 2 == 0 ? 3 : -3);
        const auto hit = surface.first_hit(on + across, -across, 0, kFar);
        ASSERT_TRUE(hit);
        // Counts round the ramp by half of 1/65535 a texel.
        EXPECT_NEAR(hit->t, 1, 3e-5);
        EXPECT_NEAR(glm::dot(hit->normal, glm::normalize(dvec3(-2.0 * 17 / 16, 0, 1))), 1, 1e-8);
        EXPECT_NEAR(glm::distance(on + across - across * hit->t, hit->position), 0, 1e-14);
    }
}

TEST(Plane, BilinearCellIsSolvedByHand) {
    // Four texels 0 0 / 0 1: in the middle cell x' = 2x - 1/2, z = A x' y'. Along p + t d this is a
    // quadratic.
    const SampleSurface sample = plane_with(
        2, 2, [](int x, int y) { return x * y; }, 0.8, 0.0);
    const ReferenceSurface surface = sample.reference();
    int met = 0;
    for (std::uint32_t i = 0; i < 400; ++i) {
        const dvec3 p(0.25 + 0.5 * hash01(i, 0, 5), 0.25 + 0.5 * hash01(i, 1, 5), 1.5);
        const dvec3 q(0.25 + 0.5 * hash01(i, 2, 5), 0.25 + 0.5 * hash01(i, 3, 5), -0.5);
        const dvec3 d = q - p;
        const double x0 = 2 * p.x - 0.5, y0 = 2 * p.y - 0.5, xd = 2 * d.x, yd = 2 * d.y;
        const double a = -0.8 * xd * yd, b = d.z - 0.8 * (x0 * yd + y0 * xd), c = p.z - 0.8 * x0 * y0;
        const double root = std::sqrt(b * b - 4 * a * c);
        // The stable pair of roots; p is above the cell and q below it, so one root lies between.
        const double k = -0.5 * (b + (b < 0 ? -root : root));
        double expected = kFar;
        for (const double t : {k / a, c / k})
            if (t >= 0 && t <= 1) expected = std::min(expected, t);
        ASSERT_LT(expected, kFar);
        const auto hit = surface.first_hit(p, d, 0, 1);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->t, expected, 1e-14);
        ++met;
    }
    EXPECT_EQ(met, 400);
}

TEST(Plane, CliffsAreSteepFacesOneTexelWide) {
    // Columns 0, 1, 0, 1, ...: a triangle wave of period 2 texels. A horizontal ray at half height meets the
    // first rising face of the texel pair that it comes to, at the middle between two centres.
    const int size = 32;
    const SampleSurface sample = plane_with(
        size, size, [](int x, int) { return x % 2; }, 5.0, 0.0, Wrap::repeat);
    const ReferenceSurface surface = sample.reference();
    for (int k = 0; k + 1 < size; ++k) {
        const double start = (k + 0.5) / size;
        const double z = k % 2 == 0 ? 2.6 : 2.4;
        // From a centre of an even column (height 0, under the ray) the face rises to 5 over one texel.
        const auto hit = surface.first_hit({start, 0.37, z}, {1, 0, 0}, 0, kFar);
        ASSERT_TRUE(hit) << k;
        const double along = k % 2 == 0 ? z / 5 : 1 - z / 5;
        EXPECT_NEAR(hit->t * size, along, 1e-12) << k;
    }
}

TEST(Plane, OneTexelSpikeIsMetFromEverySide) {
    const int size = 65;
    const SampleSurface sample = plane_with(
        size, size, [](int x, int y) { return x == 32 && y == 32; }, 3.0, 0.0, Wrap::repeat);
    const ReferenceSurface surface = sample.reference();
    for (int i = 0; i < 64; ++i) {
        const double angle = 0.01 + i * 0.0981747704,
                     height = 3.0 * (0.02 + 0.95 * hash01(static_cast<std::uint32_t>(i), 0, 9));
        const dvec3 d(std::cos(angle), std::sin(angle), 0);
        const dvec3 from = dvec3(0.5, 0.5, height) - d * 0.4;
        const auto hit = surface.first_hit(from, d, 0, kFar);
        ASSERT_TRUE(hit) << i;
        // z = A (1 - s|cos|)(1 - s|sin|) at s texels from the top.
        const double s = (0.4 - hit->t) * size;
        EXPECT_NEAR(3.0 * (1 - s * std::abs(d.x)) * (1 - s * std::abs(d.y)), height, 1e-11);
        EXPECT_GT(s, 0);
    }
    EXPECT_FALSE(surface.first_hit({0.1, 0.5, 3.0 + 1e-9}, {1, 0, 0}, 0, kFar));
}

TEST(Plane, MapsOfOneRowOrColumnWrapAndClamp) {
    for (const bool clamp : {true, false}) {
        SampleSurface column = plane_with(
            1, 4, [](int, int y) { return y / 3.0; }, 1.0, 0.0, clamp ? Wrap::clamp : Wrap::repeat);
        column.mesh = plane_mesh(3, -1);
        SampleSurface row = column;
        row.paint(4, 1, [](int x, int) { return x / 3.0; });
        const ReferenceSurface along_y = column.reference(), along_x = row.reference();
        for (int i = 0; i <= 300; ++i) {
            const double place = i / 300.0;
            const double texel = (3 * place - 1) * 4 - 0.5;
            const double cell = std::floor(texel), f = texel - cell;
            const auto value = [&](double k) {
                return clamp ? std::clamp(k, 0.0, 3.0) / 3 : (k - 4 * std::floor(k / 4)) / 3;
            };
            const double z = value(cell) * (1 - f) + value(cell + 1) * f;
            const auto hit_y = along_y.first_hit({0.31, place, 4}, {0, 0, -1}, 0, kFar);
            const auto hit_x = along_x.first_hit({place, 0.31, 4}, {0, 0, -1}, 0, kFar);
            ASSERT_TRUE(hit_x && hit_y) << i << (clamp ? " clamp" : " repeat");
            EXPECT_NEAR(hit_y->t, 4 - z, 1e-12) << i;
            EXPECT_NEAR(hit_x->t, 4 - z, 1e-12) << i;
        }
    }
}

TEST(Sphere, ConstantMapOnFlatFacesSolvesAScalarEquation) {
    // N = P/R on every face, so S = P (1 + D/|P|): for X on S and the face's plane P.ng = h, |X| (1 -
    // h/(X.ng)) = D.
    for (const double d : {0.3, -0.3, 1e-6, 2.5}) {
        SampleSurface sample;
        sample.mesh = ball_mesh(12, 7);
        sample.amplitude = d;
        sample.texels = {65535};
        const ReferenceSurface surface = sample.reference();
        for (std::uint32_t i = 0; i < 200; ++i) {
            const dvec3 to =
                glm::normalize(dvec3(hash01(i, 0, 2), hash01(i, 1, 2), hash01(i, 2, 2)) - 0.5) * 0.2;
            const dvec3 from =
                glm::normalize(dvec3(hash01(i, 3, 2), hash01(i, 4, 2), hash01(i, 5, 2)) - 0.5) * 8.0;
            const auto hit = surface.first_hit(from, to - from, 0, kFar);
            ASSERT_TRUE(hit) << d << " " << i;
            const Mesh::Face& f = sample.mesh.faces[hit->face];
            const dvec3 a = sample.mesh.positions[f.position[0]], b = sample.mesh.positions[f.position[1]],
                        c = sample.mesh.positions[f.position[2]];
            const dvec3 ng = glm::normalize(glm::cross(b - a, c - a)), x = from + (to - from) * hit->t;
            EXPECT_NEAR(glm::length(x) * (1 - glm::dot(a, ng) / glm::dot(x, ng)), d,
                        1e-7);  // normals are float
        }
    }
}

TEST(Opacity, AHoleLetsTheRayThroughToTheNextSheet) {
    SampleSurface sample = plane_with(
        4, 4, [](int, int) { return 1.0; }, 0.5, 0.0);
    sample.opacity = {0, 0, 255, 255};  // two rows of two: the lower half is a hole
    sample.opacity_width = 2;
    SampleSurface below = plane_with(
        4, 4, [](int, int) { return 0.0; }, 0.5, 0.0);
    const std::array<ReferenceObject, 2> objects{sample.object(), below.object()};
    const ReferenceSurface surface(objects);
    for (int i = 1; i < 100; ++i) {
        const double y = i / 100.0;
        const auto hit = surface.first_hit({0.4, y, 2}, {0, 0, -1}, 0, kFar);
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->object, y < 0.5 ? 1u : 0u) << y;
    }
}

}  // namespace
}  // namespace relievo::test::closed_forms_test
