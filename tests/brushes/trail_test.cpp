// Strokes that keep the strongest of their dabs: a straight pass is as even along its way as one of the tools that add.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "brushes/dab_trail.h"
#include "chart_surface.h"

namespace relievo::trail_test {
namespace {

constexpr int kSize = 512;
constexpr std::uint16_t kBefore = 40000;

struct Plane {
    Plane() : map(kSize, kSize, kBefore), colours(kSize, kSize, 16, {0, 0, 0}), surface(map, {unit_chart(map)}, 0.2f),
              sculptor(map, surface) {
        sculptor.set_colours(colours);
    }
    HeightMap map;
    ColourMap colours;
    ChartSurface surface;
    Sculptor sculptor;
};

Brush held_brush(Tool tool) {
    Brush brush;
    brush.tool = tool;
    brush.radius = 0.1f;
    brush.strength = 0.5f;
    brush.accumulate = false;
    brush.level = 0.9f;
    return brush;
}

// The largest change from one side of the stroke's way to the other, along its middle part, over the stroke's own.
double ribs(const HeightMap& map, double before) {
    double most = 0, deepest = 0;
    for (int y = kSize / 2; y < kSize / 2 + 45; ++y) {
        double low = 1e9, high = -1e9;
        for (int x = kSize * 2 / 5; x < kSize * 3 / 5; ++x) {
            const double change = map.at(x, y) - before;
            low = std::min(low, change);
            high = std::max(high, change);
        }
        most = std::max(most, high - low);
        deepest = std::max({deepest, std::abs(low), std::abs(high)});
    }
    return most / deepest;
}

constexpr double kLeast = 0.003;  // 0.013 to 0.016 where the dabs are balls

TEST(Trail, a_stroke_at_the_usual_spacing_leaves_no_ribs) {
    for (const Tool tool : {Tool::level, Tool::erase, Tool::draw, Tool::clone}) {
        Plane plane;
        if (tool == Tool::clone) std::fill_n(plane.map.texels().begin(), kSize * kSize / 2, std::uint16_t{37000});
        stroke(plane.sculptor, plane.surface, held_brush(tool), {0.2, 0.5}, {0.8, 0.5});
        EXPECT_LT(ribs(plane.map, kBefore), kLeast) << static_cast<int>(tool);
    }
    Plane masked;
    stroke(masked.sculptor, masked.surface, held_brush(Tool::mask), {0.2, 0.5}, {0.8, 0.5});
    EXPECT_LT(ribs(*masked.sculptor.mask(), 0), kLeast);
    Plane painted;
    Brush paint = held_brush(Tool::draw);
    paint.paint = Paint::colour;
    paint.red = 1;
    stroke(painted.sculptor, painted.surface, paint, {0.2, 0.5}, {0.8, 0.5});
    EXPECT_LT(ribs(painted.colours.plane(0), 0), kLeast);
}

TEST(Trail, dabs_far_apart_stay_apart_and_between_the_trail_shrinks_evenly) {
    const auto length = [](float way) {
        const DabTrail trail({0, 0, 0}, {2 * way, 0, 0}, 2);
        return trail.is_point() ? 0.0f : 2 - trail.distance({-2, 0, 0});
    };
    EXPECT_FLOAT_EQ(length(0.15f), 0.3f);
    EXPECT_FLOAT_EQ(length(0.25f), 0.5f);
    EXPECT_NEAR(length(0.375f), 0.25f, 1e-6f);
    EXPECT_EQ(length(0.5f), 0);
    EXPECT_EQ(length(3), 0);
    EXPECT_EQ(length(0), 0);
    for (float way = 0; way < 0.6f; way += 0.01f) EXPECT_NEAR(length(way), length(way + 0.01f), 0.021f) << way;
    const DabTrail trail({1, 2, 3}, {0.2f, 0, 0}, 1);
    EXPECT_FLOAT_EQ(trail.distance({0.9f, 2.5f, 3}), 0.5f);
    EXPECT_FLOAT_EQ(trail.distance({1.3f, 2, 3.4f}), 0.5f);
    EXPECT_FLOAT_EQ(trail.distance({0.5f, 2, 3.4f}), 0.5f);
    EXPECT_LE(glm::length(trail.middle() - glm::vec3(0.8f, 2, 3)) + 1, trail.reach(1));
}

}  // namespace
}  // namespace relievo::trail_test
