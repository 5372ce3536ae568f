// Shifted gutters: what they hold at the ends of the range, in a stroke and in a whole map, and bad tables.
#include "brushes/seam_bends.h"

#include <gtest/gtest.h>

#include "chart_surface.h"

namespace relievo::seam_bends_test {
namespace {

constexpr std::int32_t kHalf = SeamBend::kOne / 2;

// Texels 0 to 8 of a row: sides A at 0 to 2 and B at 3 to 5 (behind, inside, ahead), gutters at 6 and 7.
SeamTable one_column(std::int32_t lean, std::int32_t bend) {
    SeamTable table;
    table.bends.push_back({{1, 4}, {6, 7}, {2, 5}, {0, 3}, lean, {bend, bend}});
    return table;
}

std::vector<std::uint16_t> gutters(const SeamTable& table, std::vector<std::uint16_t> sides) {
    HeightMap map(8, 1);
    std::copy(sides.begin(), sides.end(), map.texels().begin());
    SeamBends(table, 8, 1).apply(map);
    EXPECT_TRUE(std::equal(sides.begin(), sides.end(), map.texels().begin()));
    return {map.texels()[6], map.texels()[7]};
}

using Counts = std::vector<std::uint16_t>;

TEST(SeamBends, level_heights_are_copied) {
    EXPECT_EQ(gutters(one_column(kHalf, kHalf), {700, 700, 700, 700, 700, 700}), (Counts{700, 700}));
}

TEST(SeamBends, a_slope_along_the_seam_shifts_both_gutters_alike) {
    EXPECT_EQ(gutters(one_column(0, kHalf / 2), {100, 200, 300, 150, 250, 350}), (Counts{350, 300}));
    EXPECT_EQ(gutters(one_column(0, -kHalf / 2), {100, 200, 300, 150, 250, 350}), (Counts{150, 100}));
}

TEST(SeamBends, another_scale_across_it_weights_the_sides) {
    EXPECT_EQ(gutters(one_column(kHalf, 0), {200, 200, 200, 300, 300, 300}), (Counts{250, 150}));
}

TEST(SeamBends, halves_are_rounded_away_from_none) {
    EXPECT_EQ(gutters(one_column(0, kHalf), {100, 100, 103, 100, 100, 100}), (Counts{102, 102}));
    EXPECT_EQ(gutters(one_column(0, -kHalf), {100, 100, 103, 100, 100, 100}), (Counts{98, 98}));
}

TEST(SeamBends, no_gutter_leaves_the_range) {
    const SeamTable steep = one_column(0, 4 * SeamBend::kOne);
    EXPECT_EQ(gutters(steep, {0, 65535, 65535, 0, 65535, 65535}), (Counts{65535, 65535}));
    EXPECT_EQ(gutters(steep, {65535, 0, 0, 65535, 0, 0}), (Counts{0, 0}));
    EXPECT_EQ(gutters(steep, {0, 0, 65535, 0, 65535, 65535}), (Counts{65535, 0}));
}

TEST(SeamBends, a_cliff_gets_no_tower) {
    EXPECT_EQ(gutters(one_column(0, 4 * SeamBend::kOne), {1000, 1000, 1100, 1000, 1000, 1100}),
              (Counts{1100, 1100}));
}

// Islands with the corner texels 0, 1 and 2; gutters of the columns at 3 to 8, of the corner at 9 to 11.
SeamTable three_islands(std::int32_t bend) {
    SeamTable table;
    for (const std::uint32_t k : {0u, 1u, 2u}) {
        const std::uint32_t a = (k + 1) % 3, b = (k + 2) % 3;
        table.bends.push_back({{a, b}, {3 + 2 * k, 4 + 2 * k}, {12 + a, 12 + b}, {a, b}, 0, {bend, bend}});
    }
    table.corners.push_back({{9, 10, 11}, {0, 1, 2}, {0, 1, 2}, {1, 1, 1}});
    return table;
}

TEST(SeamBends, a_corner_is_as_high_on_every_island) {
    for (const Counts& start : {Counts{100, 200, 400}, {0, 65535, 0}, {65535, 65535, 65535}, {0, 0, 1}})
        for (const Counts& next : {Counts{150, 250, 380}, {65535, 0, 65535}, {0, 0, 0}}) {
            HeightMap map(16, 1);
            std::copy(start.begin(), start.end(), map.texels().begin());
            std::copy(next.begin(), next.end(), map.texels().begin() + 12);
            SeamBends(three_islands(kHalf), 16, 1).apply(map);
            const auto at = [&](std::size_t i) { return int{map.texels()[i]}; };
            // The vertex, from island 0: its texel, past the seams of columns 1 and 2, and past their ends.
            const int first = at(0) + at(5 + 1) + at(7) + at(9);
            EXPECT_EQ(first, at(1) + at(8) + at(3) + at(10));
            EXPECT_EQ(first, at(2) + at(4) + at(5) + at(11));
        }
}

TEST(SeamBends, a_stroke_that_touches_one_column_of_a_corner_sets_all_three) {
    HeightMap map(16, 1, 1000);
    const SeamBends bends(three_islands(kHalf), 16, 1);
    bends.apply(map);
    map.set(13, 0, 1100);  // as an older map may be: a column that its gutters do not know of
    HeightMap whole = map;
    whole.set(12, 0, 1300);
    bends.apply(whole);
    StrokeTiles stroke(map);
    stroke.set_value(12, 0, 1300.0f);
    bends.follow(stroke);
    EXPECT_EQ(map.hash(), whole.hash());
    EXPECT_EQ(stroke.value(9, 0), static_cast<float>(map.at(9, 0)));
    stroke.restore();
    EXPECT_EQ(map.at(9, 0), 1000);
}

TEST(SeamBends, a_table_that_leaves_the_map_is_refused) {
    SeamTable table = one_column(0, 0);
    EXPECT_THROW(SeamBends(table, 7, 1), std::invalid_argument);
    table = three_islands(0);
    table.corners[0].bend[2] = 3;
    EXPECT_THROW(SeamBends(table, 16, 1), std::invalid_argument);
    HeightMap map(4, 1);
    ChartSurface surface(map, {unit_chart(map)}, 1.0f);
    surface.table = one_column(0, 0);
    EXPECT_THROW(Sculptor(map, surface), std::invalid_argument);
}

}  // namespace
}  // namespace relievo::seam_bends_test
