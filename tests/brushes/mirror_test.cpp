// Strokes on and across the plane of a mirror: no stronger along it, and no groove where they cross it.
#include <gtest/gtest.h>

#include <cmath>

#include "chart_surface.h"

namespace relievo::mirror_test {
namespace {

constexpr int kSize = 256;
constexpr float kRadius = 0.1f;

// The square [-0.5, 0.5]^2, mirrored across x = 0.
struct Sheet {
    Sheet()
        : map(kSize, kSize),
          surface(map, {{{-0.5, -0.5}, {0.5, 0.5}, {0, 0}, {kSize, 0}, {0, kSize}}}, 0.5f),
          sculptor(map, surface) {}

    void stroke(Tool tool, bool mirror, glm::dvec2 from, glm::dvec2 to) {
        Brush brush;
        brush.tool = tool;
        brush.radius = kRadius;
        brush.strength = 0.5f;
        brush.grain = 4;
        brush.mirror_x = mirror;
        sculptor.begin(brush);
        const double length = std::hypot(to.x - from.x, to.y - from.y);
        const int count = static_cast<int>(length / double{brush.spacing * brush.radius});
        for (int i = 0; i <= count; ++i) {
            const glm::dvec2 at = from + (to - from) * (static_cast<double>(i) / count);
            const Dab copy = surface.dab(-at.x, at.y);
            const FacePoint point{copy.face, copy.b1, copy.b2};
            sculptor.dab(surface.dab(at.x, at.y), std::span(&point, mirror ? 1 : 0));
        }
        sculptor.end();
    }
    double rise(double x, double y) const { return surface.counts(0, {x, y}) - 32768; }

    HeightMap map;
    ChartSurface surface;
    Sculptor sculptor;
};

TEST(Mirror, a_stroke_across_the_plane_is_as_high_there_as_beside_it) {
    for (const Tool tool : {Tool::draw, Tool::inflate}) {
        Sheet sheet;
        sheet.stroke(tool, true, {-0.4, 0}, {0.4, 0});
        const double beside = sheet.rise(0.22, 0);
        EXPECT_GT(beside, 1000);
        for (double x = 0; x < 0.2; x += 0.01)
            EXPECT_NEAR(sheet.rise(x, 0), beside, 0.03 * beside) << "at " << x;
    }
}

TEST(Mirror, a_stroke_up_to_the_plane_meets_its_image_without_a_groove) {
    Sheet sheet;
    sheet.stroke(Tool::draw, true, {-0.4, 0}, {0, 0});
    const double beside = sheet.rise(0.2, 0);
    EXPECT_GT(beside, 1000);
    for (double x = 0; x < 0.2; x += 0.01) {
        EXPECT_GE(sheet.rise(x, 0), 0.97 * beside) << "at " << x;
        EXPECT_LE(sheet.rise(x, 0), 1.2 * beside)
            << "at " << x << ": one dab more, where the last lies on its image";
    }
}

TEST(Mirror, a_stroke_along_the_plane_is_no_stronger_than_without) {
    for (const Tool tool : {Tool::draw, Tool::noise}) {
        Sheet once, mirrored;
        once.stroke(tool, false, {0, -0.4}, {0, 0.4});
        mirrored.stroke(tool, true, {0, -0.4}, {0, 0.4});
        for (double y = -0.3; y < 0.3; y += 0.05)
            EXPECT_NEAR(mirrored.rise(0, y), once.rise(0, y), 3) << "at " << y;
    }
}

TEST(Mirror, a_slanted_stroke_is_nowhere_higher_than_two_that_cross) {
    Sheet once, mirrored;
    once.stroke(Tool::draw, false, {-0.3, -0.3}, {0.3, 0.3});
    once.stroke(Tool::draw, false, {0.3, -0.3}, {-0.3, 0.3});
    mirrored.stroke(Tool::draw, true, {-0.3, -0.3}, {0.3, 0.3});
    const double highest = once.rise(0, 0);
    for (double y = -0.3; y <= 0.3; y += 0.02)
        for (double x = -0.3; x <= 0.3; x += 0.02)
            EXPECT_LE(mirrored.rise(x, y), once.rise(x, y) + 0.02 * highest);
}

}  // namespace
}  // namespace relievo::mirror_test
