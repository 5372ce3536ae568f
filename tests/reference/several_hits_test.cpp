// Several hits of a ray with one triangle, each known in closed form: all of them are found, in order.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tests/reference/sample_surfaces.h"

namespace relievo::test::several_hits_test {
namespace {

using glm::dvec3;

// Every hit of the ray, each sought behind the one before it.
std::vector<ReferenceHit> all_hits(const ReferenceSurface& surface, const dvec3& o, const dvec3& d,
                                   double apart) {
    std::vector<ReferenceHit> hits;
    double from = 0;
    while (const auto hit = surface.first_hit(o, d, from, 1e30)) {
        hits.push_back(*hit);
        from = hit->t + apart;
        if (hits.size() > 1000) break;
    }
    return hits;
}

TEST(SeveralHits, OfTheTeethOfASawOnOneTriangleEverySideIsMet) {
    // Columns 0, 1, 0, 1, ...: a triangle wave of period 2 texels, height 0.4, on a single triangle.
    const int size = 32;
    SampleSurface sample;
    sample.mesh = triangle_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1});
    sample.amplitude = 0.4;
    sample.paint(size, size, [](int x, int) { return x % 2; });
    const ReferenceSurface surface = sample.reference();
    const double height = 0.1;  // a quarter up: the sides are met at 1/4 and 7/4 of every period
    const auto hits = all_hits(surface, {-1, 0.3, height}, {1, 0, 0}, 1e-9);
    std::vector<double> expected;
    for (int k = -1; k < size; ++k) {
        const double x = (k + 0.5 + (k % 2 == 0 ? 0.25 : 0.75)) / size;
        if (x >= 0 && x <= 0.7) expected.push_back(x);
    }
    ASSERT_EQ(hits.size(), expected.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
        EXPECT_NEAR(hits[i].t, 1 + expected[i], 1e-12);
        EXPECT_EQ(hits[i].face, 0u);
    }
}

TEST(SeveralHits, OfAFoldedShellEverySheetIsMet) {
    // Normals that lean inwards by 45 degrees along x: with the map at 1, S on the side y = 0 stands over
    // X + D k / sqrt(1 + k^2), k = 1 - 2 X, which runs back in the middle once D > 1/2: three sheets there.
    SampleSurface sample;
    sample.mesh = triangle_mesh({0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {1, 0, 1}, {-1, 0, 1}, {0, 0, 1});
    sample.amplitude = 0.6;
    sample.texels = {65535};
    const ReferenceSurface surface = sample.reference();
    // N(b) is linear in b: on the side y = 0, N = (1 - 2 b1, 0, 1) / sqrt(2).
    const auto place = [&](double b1) {
        const dvec3 n = glm::normalize(dvec3(1 - 2 * b1, 0, 1));
        return dvec3(b1, 0, 0) + sample.amplitude * n;
    };
    // Downwards along y = 0: the sheets over the ray are the grid's intervals of b1 that hold its x.
    for (const double x : {0.38, 0.43, 0.48, 0.493, 0.511, 0.53, 0.60}) {
        int sheets = 0;
        for (int i = 0; i < 20000; ++i)
            sheets += (place(i / 20000.0).x < x) != (place((i + 1) / 20000.0).x < x) ? 1 : 0;
        const auto hits = all_hits(surface, {x, 1e-9, 5}, {0, 0, -1}, 1e-9);
        EXPECT_EQ(static_cast<int>(hits.size()), sheets) << x;
        for (const ReferenceHit& hit : hits) EXPECT_NEAR(place(hit.b1).x, x, 1e-6) << x;
    }
    EXPECT_EQ(all_hits(surface, {0.48, 1e-9, 5}, {0, 0, -1}, 1e-9).size(), 3u);
}

TEST(SeveralHits, FromInsideABallOfRidgesTheFirstIsTheNearestOfAll) {
    SampleSurface sample;
    sample.mesh = ball_mesh(24, 12);
    sample.amplitude = 0.3;
    sample.midlevel = 0.5;
    sample.paint(96, 48, [](int x, int y) { return x % 6 == 2 || y % 6 == 3 ? 1.0 : 0.0; });
    const ReferenceSurface surface = sample.reference();
    int several = 0;
    for (std::uint32_t i = 0; i < 200; ++i) {
        const dvec3 o = (dvec3(hash01(i, 0, 8), hash01(i, 1, 8), hash01(i, 2, 8)) - 0.5) * 0.8;
        const dvec3 d = glm::normalize(dvec3(hash01(i, 3, 8), hash01(i, 4, 8), hash01(i, 5, 8)) - 0.5);
        const auto hits = all_hits(surface, o, d, 1e-7);
        // A closed surface: from inside to outside an odd number of sheets, but for grazing contacts.
        ASSERT_FALSE(hits.empty()) << i;
        several += hits.size() > 1 ? 1 : 0;
        // Backwards from each hit to its predecessor nothing lies between.
        for (std::size_t k = 1; k < hits.size(); ++k) {
            const double gap = hits[k].t - hits[k - 1].t;
            const auto back = surface.first_hit(o + d * hits[k].t, -d, 1e-7, gap + 1e-7);
            ASSERT_TRUE(back) << i;
            EXPECT_NEAR(back->t, gap, 1e-6) << i;
        }
    }
    EXPECT_GT(several, 20);
}

}  // namespace
}  // namespace relievo::test::several_hits_test
