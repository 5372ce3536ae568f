// Each tool's effect on a flat surface whose right answer is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "brushes/dab_tools.h"
#include "relief_plane.h"

namespace relievo::tools_test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// Squared differences of neighbours: what smoothing lowers.
double roughness(const HeightMap& map) {
    double sum = 0;
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x + 1 < map.width(); ++x) sum += std::pow(map.at(x + 1, y) - map.at(x, y), 2);
    return sum;
}

TEST(Draw, one_dab_raises_by_the_documented_part_of_the_radius) {
    Plane plane;
    const Brush brush = brush_of(Tool::draw);
    tap(plane.sculptor, plane.surface, brush, {0.5, 0.5});
    const double rise = (plane.at(0.5, 0.5) - 32768) / 65535.0 * 0.2;
    EXPECT_LE(rise, kDrawRise * brush.radius * brush.spacing * 1.0001);
    EXPECT_GE(rise, kDrawRise * brush.radius * brush.spacing * 0.98);
    EXPECT_EQ(plane.at(0.5, 0.65), 32768) << "outside the radius";
}

TEST(Draw, inverted_lowers_by_as_much) {
    Plane up, down;
    Brush brush = brush_of(Tool::draw);
    tap(up.sculptor, up.surface, brush, {0.5, 0.5});
    brush.invert = true;
    tap(down.sculptor, down.surface, brush, {0.5, 0.5});
    EXPECT_GT(up.at(0.5, 0.5), 32768);
    EXPECT_NEAR(up.at(0.5, 0.5) - 32768, 32768 - down.at(0.5, 0.5), 1);
}

TEST(Draw, half_strength_or_half_pressure_is_half_the_height) {
    Plane full, weak, light;
    tap(full.sculptor, full.surface, brush_of(Tool::draw), {0.5, 0.5});
    tap(weak.sculptor, weak.surface, brush_of(Tool::draw, 0.1f, 0.5f), {0.5, 0.5});
    light.sculptor.begin(brush_of(Tool::draw));
    light.sculptor.dab(light.surface.dab(0.5, 0.5, 0.5));
    light.sculptor.end();
    EXPECT_NEAR(weak.at(0.5, 0.5) - 32768, (full.at(0.5, 0.5) - 32768) / 2.0, 1);
    EXPECT_NEAR(light.at(0.5, 0.5) - 32768, (full.at(0.5, 0.5) - 32768) / 2.0, 1);
}

TEST(Draw, negative_amplitude_raises_by_lowering_the_map) {
    Plane plane(256, 32768, -0.2f);
    tap(plane.sculptor, plane.surface, brush_of(Tool::draw), {0.5, 0.5});
    EXPECT_LT(plane.at(0.5, 0.5), 32768);
}

TEST(Draw, halving_the_spacing_gives_nearly_the_same_height) {
    int heights[3];
    int i = 0;
    for (const float spacing : {0.2f, 0.1f, 0.05f}) {
        Plane plane;
        Brush brush = brush_of(Tool::draw, 0.1f, 0.3f);
        brush.spacing = spacing;
        stroke(plane.sculptor, plane.surface, brush, {0.2, 0.5}, {0.8, 0.5});
        heights[i++] = plane.at(0.5, 0.5) - 32768;
    }
    EXPECT_NEAR(heights[1], heights[0], 0.03 * heights[0]);
    EXPECT_NEAR(heights[2], heights[1], 0.03 * heights[1]);
    EXPECT_NEAR(heights[2] / 65535.0 * 0.2, 0.3 * double{kDrawRise} * 0.1,
                0.1 * 0.3 * double{kDrawRise} * 0.1);
}

TEST(EveryTool, amplitude_zero_or_subnormal_or_not_finite_does_nothing) {
    for (const float amplitude :
         {0.0f, -0.0f, std::numeric_limits<float>::denorm_min() * 0.0f, kInfinity, kNaN})
        for (const ToolInfo& info : tools()) {
            Plane plane(32, 20000, amplitude);
            const std::uint64_t before = plane.map.hash();
            stroke(plane.sculptor, plane.surface, brush_of(info.tool, 0.3f), {0.3, 0.3}, {0.7, 0.7});
            EXPECT_EQ(plane.map.hash(), before) << info.name << " at amplitude " << amplitude;
            EXPECT_TRUE(!plane.sculptor.can_undo() || info.tool == Tool::mask);
        }
}

TEST(EveryTool, amplitude_of_a_millionth_and_of_a_million_stays_in_range) {
    for (const float amplitude : {1e-6f, -1e-6f, 1e-38f, 1e6f, -1e6f})
        for (const ToolInfo& info : tools()) {
            Plane plane(32, 20000, amplitude);
            fill(plane.map, [](int x, int y) { return 20000 + 997 * ((x * 7 + y * 13) % 31); });
            stroke(plane.sculptor, plane.surface, brush_of(info.tool, 0.3f), {0.3, 0.3}, {0.7, 0.7});
            EXPECT_TRUE(plane.sculptor.undo_bytes() > 0 || !plane.sculptor.can_undo()) << info.name;
        }
}

TEST(EveryTool, maps_of_one_texel_one_row_and_one_column) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 37}, {37, 1}, {2, 2}, {65, 3}})
        for (const ToolInfo& info : tools()) {
            HeightMap map(width, height, 20000);
            const ChartSurface surface(map, {unit_chart(map)}, 0.5f);
            Sculptor sculptor(map, surface);
            const std::uint64_t before = map.hash();
            stroke(sculptor, surface, brush_of(info.tool, 0.7f), {0.4, 0.4}, {0.6, 0.6});
            const bool changes = holds(tool_set({Tool::draw, Tool::level, Tool::erase, Tool::inflate,
                                                 Tool::clay, Tool::crease, Tool::noise, Tool::stamp}),
                                       info.tool);
            EXPECT_EQ(map.hash() != before, changes) << info.name << " on " << width << " x " << height;
            sculptor.undo();
            EXPECT_EQ(map.hash(), before);
        }
}

TEST(EveryTool, radius_far_beyond_and_far_below_the_surface) {
    for (const float radius : {1e7f, 1e3f, 1e-7f})
        for (const ToolInfo& info : tools()) {
            Plane plane(64, 20000);
            fill(plane.map, [](int x, int y) { return 20000 + 10000 * ((x / 8 + y / 8) % 2); });
            tap(plane.sculptor, plane.surface, brush_of(info.tool, radius), {0.503, 0.503});
            EXPECT_TRUE(radius > 1.0f || !plane.sculptor.can_undo())
                << info.name << ": no texel lies so near";
        }
}

TEST(EveryTool, settings_out_of_range_are_rejected_by_name) {
    Plane plane(16);
    const auto rejected = [&](auto change, const char* name) {
        Brush brush;
        change(brush);
        try {
            plane.sculptor.begin(brush);
        } catch (const std::invalid_argument& error) {
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
            EXPECT_FALSE(plane.sculptor.in_stroke());
            return;
        }
        ADD_FAILURE() << name << " was taken";
        plane.sculptor.cancel();
    };
    for (const float bad : {kNaN, kInfinity, -1.0f, 0.0f})
        rejected([&](Brush& b) { b.radius = bad; }, "radius");
    for (const float bad : {kNaN, -0.1f, 1.1f}) rejected([&](Brush& b) { b.strength = bad; }, "strength");
    for (const float bad : {kNaN, 1.0f}) rejected([&](Brush& b) { b.hardness = bad; }, "hardness");
    for (const float bad : {kNaN, 0.0f, 2.0f}) rejected([&](Brush& b) { b.spacing = bad; }, "spacing");
    for (const float bad : {kNaN, -0.1f, 1.1f}) rejected([&](Brush& b) { b.level = bad; }, "level");
}

TEST(Level, full_strength_arrives_exactly_and_half_strength_half_way) {
    Plane full, half;
    Brush brush = brush_of(Tool::level, 0.2f);
    brush.hardness = 0.5f;
    brush.level = 0.25f;
    stroke(full.sculptor, full.surface, brush, {0.4, 0.5}, {0.6, 0.5});
    EXPECT_EQ(full.at(0.5, 0.5), std::lround(0.25 * 65535));
    brush.strength = 0.5f;
    stroke(half.sculptor, half.surface, brush, {0.4, 0.5}, {0.6, 0.5});
    EXPECT_NEAR(half.at(0.5, 0.5), (32768 + 0.25 * 65535) / 2, 1) << "however many dabs";
}

TEST(Erase, full_strength_restores_the_midlevel_and_weak_strokes_never_pass_it) {
    HeightMap map(128, 128, 60000);
    const ChartSurface surface(map, {unit_chart(map)}, 0.1f, 0.3f);
    Sculptor sculptor(map, surface);
    Brush brush = brush_of(Tool::erase, 0.2f, 0.4f);
    int last = 60000;
    for (int i = 0; i < 30; ++i) {
        stroke(sculptor, surface, brush, {0.4, 0.5}, {0.6, 0.5});
        const int now = map.at(64, 64);
        EXPECT_LE(now, last);
        EXPECT_GE(now, std::lround(0.3 * 65535));
        last = now;
    }
    EXPECT_NEAR(last, 0.3 * 65535, 2);
}

TEST(Smooth, noise_goes_and_a_ramp_stays) {
    Plane noisy(128), ramp(128);
    fill(noisy.map, [](int x, int y) { return 32768 + (((x * 7919 + y * 104729) % 97) - 48) * 60.0; });
    fill(ramp.map, [](int x, int) { return 20000 + 80.0 * x; });
    const double rough = roughness(noisy.map);
    const HeightMap before = ramp.map;
    Brush brush = brush_of(Tool::smooth, 0.2f);
    brush.spacing = 0.3f;
    for (double y = 0.1; y < 1.0; y += 0.1) {
        stroke(noisy.sculptor, noisy.surface, brush, {0.0, y}, {1.0, y});
        if (y > 0.3 && y < 0.7) stroke(ramp.sculptor, ramp.surface, brush, {0.3, y}, {0.7, y});
    }
    EXPECT_LT(roughness(noisy.map), 0.01 * rough);
    double worst = 0;
    for (int y = 32; y < 96; ++y)
        for (int x = 32; x < 96; ++x)
            worst = std::max(worst, std::abs(ramp.map.at(x, y) - 1.0 * before.at(x, y)));
    EXPECT_LT(worst, 0.01 * 80.0 * 128) << "of a ramp over the whole map";
}

// The largest change of slope from texel to texel across the stroke's way, in its middle.
double sharpest_bend(const HeightMap& map) {
    const int size = map.height(), x = map.width() / 2;
    double most = 0;
    for (int y = 1; y + 1 < size; ++y) {
        double bend = 0;
        for (int column = x - 8; column < x + 8; ++column)
            bend += map.at(column, y + 1) - 2.0 * map.at(column, y) + map.at(column, y - 1);
        most = std::max(most, std::abs(bend) / 16);
    }
    return most;
}

// Averages whose slope jumps at the planes of a grid that goes along with the brush left three along a ridge.
TEST(Smooth, leaves_no_creases_along_its_way) {
    Plane plane(512);
    stroke(plane.sculptor, plane.surface, brush_of(Tool::draw, 0.1f, 0.5f), {0.2, 0.5}, {0.8, 0.5});
    const double before = sharpest_bend(plane.map);
    for (int pass = 0; pass < 3; ++pass) {
        stroke(plane.sculptor, plane.surface, brush_of(Tool::smooth, 0.1f, 0.5f), {0.2, 0.5}, {0.8, 0.5});
        EXPECT_LT(sharpest_bend(plane.map), 1.2 * before) << pass;  // 2.4 to 3.1 then
    }
}

TEST(Smooth, spike_taller_than_the_brush_melts) {
    Plane plane(128, 0, 5.0f);
    plane.map.set(64, 64, 65535);
    const Brush brush = brush_of(Tool::smooth, 0.05f);
    for (int i = 0; i < 40; ++i) tap(plane.sculptor, plane.surface, brush, {64.5 / 128, 64.5 / 128});
    EXPECT_LT(plane.map.at(64, 64), 1000);
}

TEST(Smooth, checkerboard_of_0_and_65535_meets_in_the_middle) {
    Plane plane(64, 0, 1e-3f);
    fill(plane.map, [](int x, int y) { return (x + y) % 2 * 65535.0; });
    const Brush brush = brush_of(Tool::smooth, 0.3f);
    for (int i = 0; i < 10; ++i) tap(plane.sculptor, plane.surface, brush, {0.5, 0.5});
    EXPECT_NEAR(plane.at(0.5, 0.5), 32768, 700);
}

TEST(Flatten, bumps_sink_into_their_plane_and_a_slope_stays) {
    Plane bumpy, slope;
    fill(bumpy.map, [](int x, int y) { return 32768 + 3000 * std::sin(x * 0.9) * std::sin(y * 0.9); });
    fill(slope.map, [](int x, int) { return 20000 + 60.0 * x; });
    const HeightMap before = slope.map;
    const Brush brush = brush_of(Tool::flatten, 0.2f);
    for (int i = 0; i < 20; ++i) {
        tap(bumpy.sculptor, bumpy.surface, brush, {0.5, 0.5});
        tap(slope.sculptor, slope.surface, brush, {0.5, 0.5});
    }
    for (int y = 118; y < 138; ++y)
        for (int x = 118; x < 138; ++x) {
            EXPECT_NEAR(bumpy.map.at(x, y), 32768, 150);
            EXPECT_NEAR(slope.map.at(x, y), before.at(x, y), 40);
        }
}

TEST(Falloff, is_one_within_the_hardness_and_falls_to_the_rim) {
    for (const Falloff falloff :
         {Falloff::smooth, Falloff::linear, Falloff::sharp, Falloff::constant, Falloff::custom})
        for (const float hardness : {0.0f, 0.4f, 0.99f}) {
            Brush brush;
            brush.falloff = falloff, brush.hardness = hardness;
            EXPECT_EQ(falloff_weight(brush, 0.0f), 1.0f);
            EXPECT_EQ(falloff_weight(brush, hardness), 1.0f);
            EXPECT_NEAR(falloff_weight(brush, 1.0f), falloff == Falloff::constant ? 1.0f : 0.0f, 1e-6f);
            for (float x = 0.0f; x < 0.99f; x += 0.01f)
                EXPECT_GE(falloff_weight(brush, x), falloff_weight(brush, x + 0.01f));
        }
}

}  // namespace
}  // namespace relievo::tools_test
