// Inflate on flat surfaces, whole and cut: rises by the slope, and strokes upon strokes stay smooth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "relief_plane.h"

namespace relievo::inflate_test {
namespace {

TEST(Inflate, flat_ground_rises_as_drawn_and_slopes_rise_more) {
    Plane flat, drawn, slope;
    tap(flat.sculptor, flat.surface, brush_of(Tool::inflate), {0.5, 0.5});
    tap(drawn.sculptor, drawn.surface, brush_of(Tool::draw), {0.5, 0.5});
    EXPECT_EQ(flat.map.hash(), drawn.map.hash());
    fill(slope.map, [](int x, int) { return 12768 + 156.25 * x; });  // 0.477 up a unit: a factor of 1.108
    const HeightMap before = slope.map;
    tap(slope.sculptor, slope.surface, brush_of(Tool::inflate), {0.5, 0.5});
    const double rise = slope.map.at(128, 128) - before.at(128, 128);
    const double factor = std::hypot(1.0, 156.25 * 256 / 65535 * 0.2);
    EXPECT_NEAR(rise, factor * (drawn.at(0.5, 0.5) - 32768), 0.01 * rise);
}

// Differences taken about a place would let spikes and waves grow behind the edges.
TEST(Inflate, many_strokes_leave_one_smooth_back) {
    for (const bool invert : {false, true}) {
        Plane plane(128, 32768, 0.6f);
        const auto up = [&](double count) { return invert ? 65535 - count : count; };
        fill(plane.map, [&](int x, int y) {
            return up(20000 + 24000 * x / 128.0 + 6000 * bump((x - 64) / 128.0, (y - 64) / 128.0, 0.1));
        });
        Brush brush = brush_of(Tool::inflate, 0.2f, 0.1f);
        brush.invert = invert;
        for (int i = 0; i < 20; ++i) stroke(plane.sculptor, plane.surface, brush, {0.46, 0.35}, {0.46, 0.65});
        const auto height = [&](int x) { return up(plane.map.at(x, 64)); };
        EXPECT_GT(height(58), 50000);
        for (int x = 20; x < 58; ++x) EXPECT_GE(height(x), height(x - 1)) << x << ' ' << invert;
    }
}

TEST(Inflate, inverted_shrinks) {
    Plane plane;
    Brush brush = brush_of(Tool::inflate);
    brush.invert = true;
    tap(plane.sculptor, plane.surface, brush, {0.5, 0.5});
    EXPECT_LT(plane.at(0.5, 0.5), 32768);
}

// Along the cut, texels of one island stand anywhere between those of the other, some almost at the same
// place: slopes between such two are noise, which dab after dab would make grow.
TEST(Inflate, a_cut_between_islands_turned_apart_does_not_show) {
    const auto relief = [](glm::dvec2 p) {
        return 20000 + 24000 * p.x + 6000 * bump(p.x - 0.5, p.y - 0.5, 0.1);
    };
    constexpr double kTexels = 128;  // a unit
    constexpr float kTall = 0.6f;
    for (const double turn : {0.2, 0.4, 0.785398}) {
        const glm::dvec2 along_x = kTexels * glm::dvec2(std::cos(turn), std::sin(turn)),
                         along_y = kTexels * glm::dvec2(-std::sin(turn), std::cos(turn));
        const std::vector<Chart> charts{{{0, 0}, {0.5, 1}, {2, 2}, {kTexels, 0}, {0, kTexels}},
                                        {{0.5, 0}, {1, 1}, {200, 10}, along_x, along_y}};
        const auto island = [](int x) { return std::size_t{x < 100 ? 0u : 1u}; };
        const auto place = [&](int x, int y) {
            return charts[island(x)].point_of(glm::dvec2(x + 0.5, y + 0.5));
        };
        HeightMap map(300, 200), whole_map(128, 128);
        const ChartSurface surface(map, charts, kTall), whole(whole_map, {unit_chart(whole_map)}, kTall);
        fill(map, [&](int x, int y) { return relief(place(x, y)); });
        fill(whole_map, [&](int x, int y) { return relief(glm::dvec2(x + 0.5, y + 0.5) / kTexels); });
        Sculptor on_cut(map, surface), on_whole(whole_map, whole);
        const Brush brush = brush_of(Tool::inflate, 0.2f, 0.1f);
        for (int i = 0; i < 20; ++i) {
            stroke(on_cut, surface, brush, {0.46, 0.35}, {0.46, 0.65});
            stroke(on_whole, whole, brush, {0.46, 0.35}, {0.46, 0.65});
        }
        double largest = 0;
        for (int y = 0; y < map.height(); ++y)
            for (int x = 0; x < map.width(); ++x) {
                const glm::dvec2 at = place(x, y);
                if (charts[island(x)].holds(at) && glm::length(at - 0.5) < 0.4)
                    largest = std::max(largest, std::abs(map.at(x, y) - whole.counts(0, at)));
            }
        EXPECT_LT(largest, 130) << turn << ": counts, after strokes of 20,000";
    }
}

}  // namespace
}  // namespace relievo::inflate_test
