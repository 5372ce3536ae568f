// Strokes as a whole: accumulation in float, undo and redo to the byte, budgets, cancelling, misuse.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <stdexcept>

#include "chart_surface.h"

namespace relievo::stroke_test {
namespace {

struct Plane {
    explicit Plane(int size, std::size_t budget = std::size_t{1} << 30)
        : map(size, size), surface(map, {unit_chart(map)}, 0.2f), sculptor(map, surface, budget) {}

    HeightMap map;
    ChartSurface surface;
    Sculptor sculptor;
};

Brush brush_of(float radius, float strength) {
    Brush brush;
    brush.radius = radius;
    brush.strength = strength;
    return brush;
}

bool covers(const std::vector<TexelRect>& rects, int x, int y) {
    return std::any_of(rects.begin(), rects.end(),
                       [&](const TexelRect& r) { return x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1; });
}

void expect_exact_cover(const HeightMap& before, const HeightMap& after,
                        const std::vector<TexelRect>& rects) {
    for (int y = 0; y < after.height(); ++y)
        for (int x = 0; x < after.width(); ++x)
            ASSERT_TRUE(before.at(x, y) == after.at(x, y) || covers(rects, x, y))
                << x << ", " << y << " changed and is not reported";
    for (std::size_t i = 0; i < rects.size(); ++i) {
        EXPECT_FALSE(rects[i].empty());
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(rects[i].overlaps(rects[j]));
    }
}

TEST(Stroke, thousand_dabs_of_a_hundredth_count_add_up_to_ten) {
    Plane plane(64);
    Brush brush = brush_of(0.2f, 1.0f);
    // One dab raises 0.5 * 0.2 * 0.15 units = 4915 counts of 0.2 / 65535 at full strength.
    brush.strength = 0.01f / 4915.1f;
    plane.sculptor.begin(brush);
    for (int i = 0; i < 1000; ++i) plane.sculptor.dab(plane.surface.dab(0.5, 0.5));
    plane.sculptor.end();
    EXPECT_NEAR(plane.map.at(32, 32) - 32768, 10, 1);
}

TEST(Stroke, map_shows_the_rounded_state_after_every_dab_and_rects_cover_what_changed) {
    Plane plane(256);
    plane.sculptor.begin(brush_of(0.1f, 0.4f));
    for (int i = 0; i < 20; ++i) {
        const HeightMap before = plane.map;
        const auto rects = plane.sculptor.dab(plane.surface.dab(0.1 + 0.04 * i, 0.5));
        EXPECT_NE(before.hash(), plane.map.hash());
        expect_exact_cover(before, plane.map, rects);
        EXPECT_LE(rects.size(), 4u);
    }
    plane.sculptor.end();
}

TEST(Stroke, same_dabs_give_the_same_bytes) {
    std::uint64_t hashes[2];
    for (std::uint64_t& hash : hashes) {
        Plane plane(256);
        for (const ToolInfo& info : tools()) {
            Brush brush = brush_of(0.1f, 0.7f);
            brush.tool = info.tool;
            stroke(plane.sculptor, plane.surface, brush, {0.2, 0.3}, {0.8, 0.6});
        }
        hash = plane.map.hash();
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(Undo, restores_all_65536_values_to_the_byte_and_redo_brings_the_stroke_back) {
    Plane plane(256);
    fill(plane.map, [](int x, int y) { return y * 256 + x; });
    const HeightMap start = plane.map;
    std::vector<HeightMap> states{start};
    for (const ToolInfo& info : tools()) {
        Brush brush = brush_of(0.2f, 0.8f);
        brush.tool = info.tool;
        const std::uint64_t steps = plane.sculptor.steps_made();
        stroke(plane.sculptor, plane.surface, brush, {0.1, 0.2}, {0.9, 0.8});
        if (plane.sculptor.steps_made() > steps) states.push_back(plane.map);
    }
    EXPECT_GE(states.size(), 10u);
    for (std::size_t i = states.size() - 1; i-- > 0;) {
        const HeightMap before = plane.map;
        expect_exact_cover(before, states[i], plane.sculptor.undo());
        EXPECT_EQ(plane.map.hash(), states[i].hash());
    }
    EXPECT_FALSE(plane.sculptor.can_undo());
    EXPECT_TRUE(plane.sculptor.undo().empty());
    EXPECT_EQ(plane.map.hash(), start.hash());
    for (std::size_t i = 1; i < states.size(); ++i) {
        plane.sculptor.redo();
        EXPECT_EQ(plane.map.hash(), states[i].hash());
    }
    EXPECT_FALSE(plane.sculptor.can_redo());
}

TEST(Undo, new_stroke_drops_redo_but_one_without_effect_does_not) {
    Plane plane(64);
    const Brush brush = brush_of(0.2f, 1.0f);
    tap(plane.sculptor, plane.surface, brush, {0.5, 0.5});
    plane.sculptor.undo();
    EXPECT_TRUE(plane.sculptor.can_redo());
    tap(plane.sculptor, plane.surface, brush_of(0.2f, 0.0f), {0.5, 0.5});
    EXPECT_TRUE(plane.sculptor.can_redo());
    EXPECT_FALSE(plane.sculptor.can_undo());
    tap(plane.sculptor, plane.surface, brush, {0.2, 0.5});
    EXPECT_FALSE(plane.sculptor.can_redo());
}

TEST(Undo, budget_holds_and_the_oldest_steps_go_first) {
    constexpr std::size_t kBudget = 100'000;
    Plane plane(256, kBudget);
    std::vector<std::uint64_t> hashes{plane.map.hash()};
    for (int i = 0; i < 12; ++i) {
        tap(plane.sculptor, plane.surface, brush_of(0.25f, 0.5f), {0.3 + 0.03 * i, 0.5});
        hashes.push_back(plane.map.hash());
        EXPECT_LE(plane.sculptor.undo_bytes(), kBudget);
    }
    std::size_t steps = 0;
    for (; plane.sculptor.can_undo(); ++steps) {
        plane.sculptor.undo();
        EXPECT_EQ(plane.map.hash(), hashes[hashes.size() - 2 - steps]);
        EXPECT_LE(plane.sculptor.undo_bytes(), kBudget);
    }
    EXPECT_GT(steps, 1u);
    EXPECT_LT(steps, 12u);
    EXPECT_EQ(plane.sculptor.undo_budget(), kBudget);
}

TEST(Undo, budget_of_zero_keeps_nothing) {
    Plane plane(64, 0);
    tap(plane.sculptor, plane.surface, brush_of(0.2f, 1.0f), {0.5, 0.5});
    EXPECT_FALSE(plane.sculptor.can_undo());
    EXPECT_EQ(plane.sculptor.undo_bytes(), 0u);
}

TEST(Undo, memory_of_a_dab_does_not_grow_with_the_map) {
    std::size_t bytes[2];
    int i = 0;
    for (const int size : {512, 8192}) {
        Plane plane(size);
        tap(plane.sculptor, plane.surface, brush_of(40.0f / static_cast<float>(size), 1.0f), {0.5, 0.5});
        bytes[i++] = plane.sculptor.undo_bytes();
    }
    EXPECT_LT(bytes[1], 2 * bytes[0]);
}

TEST(Cancel, leaves_no_trace) {
    Plane plane(128);
    const Brush brush = brush_of(0.2f, 1.0f);
    tap(plane.sculptor, plane.surface, brush, {0.5, 0.5});
    tap(plane.sculptor, plane.surface, brush, {0.4, 0.5});
    plane.sculptor.undo();
    const std::uint64_t hash = plane.map.hash();
    const std::size_t bytes = plane.sculptor.undo_bytes();
    plane.sculptor.begin(brush);
    drag(plane.sculptor, plane.surface, brush, {0.1, 0.1}, {0.9, 0.9});
    const HeightMap during = plane.map;
    const auto rects = plane.sculptor.cancel();
    EXPECT_EQ(plane.map.hash(), hash);
    EXPECT_EQ(plane.sculptor.undo_bytes(), bytes);
    EXPECT_TRUE(plane.sculptor.can_undo() && plane.sculptor.can_redo());
    EXPECT_FALSE(plane.sculptor.in_stroke());
    expect_exact_cover(during, plane.map, rects);
}

TEST(Clip, texels_pushed_beyond_the_range_are_counted_once) {
    Plane plane(64);
    const Brush brush = brush_of(0.2f, 1.0f);
    plane.sculptor.begin(brush);
    EXPECT_EQ(plane.sculptor.clipped_texels(), 0u);
    for (int i = 0; i < 30; ++i) plane.sculptor.dab(plane.surface.dab(0.5, 0.5));
    const std::size_t clipped = plane.sculptor.clipped_texels();
    EXPECT_GT(clipped, 5u);
    EXPECT_LT(clipped, 520u);
    plane.sculptor.end();
    EXPECT_EQ(plane.sculptor.clipped_texels(), clipped) << "until the next stroke";
    EXPECT_EQ(plane.map.at(32, 32), 65535);
    plane.sculptor.undo();
    EXPECT_EQ(plane.sculptor.clipped_texels(), 0u) << "the stroke is gone, and its warning";
}

TEST(Misuse, calls_out_of_order_and_dabs_off_the_mesh_throw_and_change_nothing) {
    Plane plane(32);
    EXPECT_THROW(plane.sculptor.dab({}), std::logic_error);
    EXPECT_THROW(plane.sculptor.end(), std::logic_error);
    EXPECT_THROW(plane.sculptor.cancel(), std::logic_error);
    plane.sculptor.begin(brush_of(0.2f, 1.0f));
    EXPECT_THROW(plane.sculptor.begin({}), std::logic_error);
    EXPECT_THROW(plane.sculptor.undo(), std::logic_error);
    const std::uint64_t hash = plane.map.hash();
    Dab dab;
    dab.face = 2;
    EXPECT_THROW(plane.sculptor.dab(dab), std::out_of_range);
    dab.face = 0;
    dab.b1 = dab.b2 = Dab::kBarycentricOne / 2 + 1;
    EXPECT_THROW(plane.sculptor.dab(dab), std::out_of_range);
    dab.b1 = dab.b2 = 0xffffffffu;
    EXPECT_THROW(plane.sculptor.dab(dab), std::out_of_range);
    EXPECT_EQ(plane.map.hash(), hash);
    plane.sculptor.end();
}

TEST(HeightMap, sizes_outside_the_range_are_refused_and_the_hash_sees_shape_and_texels) {
    EXPECT_THROW(HeightMap(0, 4), std::invalid_argument);
    EXPECT_THROW(HeightMap(4, -1), std::invalid_argument);
    EXPECT_THROW(HeightMap(HeightMap::kMaxSize + 1, 1), std::invalid_argument);
    EXPECT_NE(HeightMap(2, 3, 7).hash(), HeightMap(3, 2, 7).hash());
    EXPECT_NE(HeightMap(2, 2, 7).hash(), HeightMap(2, 2, 8).hash());
    // FNV-1a 64 of the bytes 01 00 00 00 01 00 00 00 34 12.
    EXPECT_EQ(HeightMap(1, 1, 0x1234).hash(), 0x2d1380fb8b025093ull);
}

}  // namespace
}  // namespace relievo::stroke_test
