// Erase to what was saved: exact at full strength, whatever strokes, undo and saves came in between.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "chart_surface.h"

namespace relievo::erase_test {
namespace {

Brush eraser(float radius, float strength = 1.0f) {
    Brush brush;
    brush.tool = Tool::erase;
    brush.erase_to = EraseTo::saved;
    brush.falloff = Falloff::constant;
    brush.radius = radius;
    brush.strength = strength;
    return brush;
}

Brush drawing(float radius) {
    Brush brush;
    brush.radius = radius;
    brush.strength = 1;
    return brush;
}

struct Sheet {
    Sheet(int width, int height)
        : map(width, height), surface(map, {unit_chart(map)}, 0.2f), sculptor(map, surface) {
        fill(map, [](int x, int y) { return 20000 + 311 * ((x * 7 + y * 13) % 17) + 40 * y; });
    }
    HeightMap map;
    ChartSurface surface;
    Sculptor sculptor;
};

TEST(EraseToSaved, the_whole_map_comes_back_to_the_last_count) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 200}, {130, 65}, {64, 64}}) {
        Sheet sheet(width, height);
        const HeightMap start = sheet.map;
        for (int i = 0; i < 5; ++i)
            stroke(sheet.sculptor, sheet.surface, drawing(0.3f), {0.2, 0.2 * i}, {0.9, 0.5});
        EXPECT_NE(sheet.map.hash(), start.hash()) << width << " x " << height;
        tap(sheet.sculptor, sheet.surface, eraser(3), {0.5, 0.5});
        EXPECT_EQ(sheet.map.hash(), start.hash()) << width << " x " << height;
        sheet.sculptor.undo();
        EXPECT_NE(sheet.map.hash(), start.hash()) << "one step of its own";
    }
}

TEST(EraseToSaved, an_unchanged_map_is_left_as_it_is) {
    Sheet sheet(100, 100);
    tap(sheet.sculptor, sheet.surface, eraser(0.3f), {0.5, 0.5});
    EXPECT_FALSE(sheet.sculptor.can_undo());
}

TEST(EraseToSaved, weak_strokes_come_nearer_and_never_pass) {
    Sheet sheet(128, 128);
    const int start = sheet.map.at(64, 64);
    Brush draw = drawing(0.2f);
    draw.invert = true;
    stroke(sheet.sculptor, sheet.surface, draw, {0.4, 0.5}, {0.6, 0.5});
    int last = sheet.map.at(64, 64);
    const int lowered = start - last;
    ASSERT_GT(lowered, 1000);
    stroke(sheet.sculptor, sheet.surface, eraser(0.2f, 0.4f), {0.4, 0.5}, {0.6, 0.5});
    EXPECT_NEAR(sheet.map.at(64, 64) - last, 0.4 * lowered, 1) << "however many dabs";
    for (int i = 0; i < 40; ++i) {
        stroke(sheet.sculptor, sheet.surface, eraser(0.2f, 0.4f), {0.4, 0.5}, {0.6, 0.5});
        EXPECT_GE(sheet.map.at(64, 64), last);
        EXPECT_LE(sheet.map.at(64, 64), start);
        last = sheet.map.at(64, 64);
    }
    EXPECT_NEAR(last, start, 1);
}

TEST(EraseToSaved, random_strokes_undo_redo_and_saves_end_at_the_last_save) {
    std::mt19937 random(11);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (int round = 0; round < 12; ++round) {
        Sheet sheet(150, 90);
        HeightMap saved = sheet.map;
        for (int i = 0; i < 40; ++i) {
            const auto what = random() % 8;
            if (what == 0) {
                sheet.sculptor.mark_saved();
                saved = sheet.map;
            } else if (what <= 2) {
                sheet.sculptor.undo();
            } else if (what == 3) {
                sheet.sculptor.redo();
            } else if (what == 4) {
                sheet.sculptor.begin(drawing(0.2f));
                sheet.sculptor.dab(sheet.surface.dab(unit(), unit()));
                sheet.sculptor.cancel();
            } else {
                Brush brush = what == 5 ? eraser(0.2f, 0.5f) : drawing(0.15f);
                brush.invert = what == 6;
                stroke(sheet.sculptor, sheet.surface, brush, {unit(), unit()}, {unit(), unit()});
            }
        }
        tap(sheet.sculptor, sheet.surface, eraser(3), {0.5, 0.5});
        ASSERT_EQ(sheet.map.hash(), saved.hash()) << "round " << round;
    }
}

TEST(EraseToSaved, a_save_ahead_of_an_undo_is_where_it_goes) {
    Sheet sheet(128, 128);
    stroke(sheet.sculptor, sheet.surface, drawing(0.2f), {0.4, 0.5}, {0.6, 0.5});
    sheet.sculptor.mark_saved();
    const std::uint64_t saved = sheet.map.hash();
    sheet.sculptor.undo();
    ASSERT_NE(sheet.map.hash(), saved);
    tap(sheet.sculptor, sheet.surface, eraser(3), {0.5, 0.5});
    EXPECT_EQ(sheet.map.hash(), saved);
}

TEST(EraseToSaved, steps_dropped_for_memory_do_not_matter) {
    HeightMap map(128, 128);
    const ChartSurface surface(map, {unit_chart(map)}, 0.2f);
    Sculptor sculptor(map, surface, 1);
    const std::uint64_t start = map.hash();
    for (int i = 0; i < 3; ++i) stroke(sculptor, surface, drawing(0.2f), {0.1, 0.3 * i}, {0.9, 0.5});
    EXPECT_FALSE(sculptor.can_undo());
    tap(sculptor, surface, eraser(3), {0.5, 0.5});
    EXPECT_EQ(map.hash(), start);
}

TEST(EraseToSaved, the_mask_protects_wholly_and_by_halves) {
    Sheet sheet(128, 128);
    const HeightMap start = sheet.map;
    stroke(sheet.sculptor, sheet.surface, drawing(1), {0.1, 0.5}, {0.9, 0.5});
    const HeightMap drawn = sheet.map;
    Brush mask = eraser(0.2f, 1.0f);
    mask.tool = Tool::mask;
    tap(sheet.sculptor, sheet.surface, mask, {0.25, 0.5});
    mask.strength = 0.5f;
    tap(sheet.sculptor, sheet.surface, mask, {0.75, 0.5});
    tap(sheet.sculptor, sheet.surface, eraser(3), {0.5, 0.5});
    EXPECT_EQ(sheet.map.at(32, 64), drawn.at(32, 64));
    EXPECT_NEAR(sheet.map.at(96, 64), (drawn.at(96, 64) + start.at(96, 64)) / 2.0, 1);
    EXPECT_EQ(sheet.map.at(64, 10), start.at(64, 10));
}

TEST(EraseToSaved, marking_during_a_stroke_is_refused) {
    Sheet sheet(16, 16);
    sheet.sculptor.begin(eraser(0.1f));
    EXPECT_THROW(sheet.sculptor.mark_saved(), std::logic_error);
    sheet.sculptor.cancel();
    Brush brush = eraser(0.1f);
    brush.erase_to = static_cast<EraseTo>(2);
    EXPECT_THROW(sheet.sculptor.begin(brush), std::invalid_argument);
}

}  // namespace
}  // namespace relievo::erase_test
