// Merging dirty rectangles: few, disjoint, and nothing lost.
#include <gtest/gtest.h>

#include "brushes/texel_rect.h"
#include "brushes/tile_rects.h"

namespace relievo::rect_test {
namespace {

bool disjoint(const std::vector<TexelRect>& rects) {
    for (std::size_t i = 0; i < rects.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (rects[i].overlaps(rects[j])) return false;
    return true;
}

bool inside_some(const TexelRect& r, const std::vector<TexelRect>& rects) {
    return std::any_of(rects.begin(), rects.end(), [&](const TexelRect& o) {
        return r.x0 >= o.x0 && r.y0 >= o.y0 && r.x1 <= o.x1 && r.y1 <= o.y1;
    });
}

TEST(MergeRects, empty_ones_vanish_and_far_ones_stay_apart) {
    const TexelRect a{0, 0, 100, 100}, b{5000, 5000, 5100, 5100};
    EXPECT_EQ(merge_rects({b, {}, a}), (std::vector<TexelRect>{a, b}));
    EXPECT_TRUE(merge_rects({}).empty());
}

TEST(MergeRects, full_block_of_tiles_is_one_rect) {
    std::vector<TexelRect> tiles;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) tiles.push_back({x * 64, y * 64, x * 64 + 64, y * 64 + 64});
    EXPECT_EQ(merge_rects(tiles), (std::vector<TexelRect>{{0, 0, 16384, 16384}}));
}

TEST(MergeRects, long_diagonal_does_not_become_its_bounding_square) {
    std::vector<TexelRect> tiles;
    for (int i = 0; i < 40; ++i) tiles.push_back({i * 64, i * 64, i * 64 + 64, i * 64 + 64});
    const auto merged = merge_rects(tiles);
    std::int64_t area = 0;
    for (const TexelRect& rect : merged) area += rect.area();
    EXPECT_LT(area, 4 * 40 * 64 * 64);
    EXPECT_TRUE(disjoint(merged));
}

TEST(MergeRects, scattered_texels_are_covered_by_at_most_the_asked_number) {
    std::vector<TexelRect> texels;
    std::uint32_t random = 1;
    for (int i = 0; i < 3000; ++i) {
        random = random * 1664525u + 1013904223u;
        const int x = static_cast<int>(random >> 8) % 8000, y = i * 2;
        texels.push_back({x, y, x + 1, y + 1});
    }
    for (const std::size_t most : {1u, 7u, 64u}) {
        const auto merged = merge_rects(texels, most);
        EXPECT_LE(merged.size(), most);
        EXPECT_TRUE(disjoint(merged));
        for (const TexelRect& texel : texels) ASSERT_TRUE(inside_some(texel, merged));
    }
}

TEST(WithoutOverlaps, WhatDoesNotOverlapStaysAsItIs) {
    const TileGrid grid(8192, 8192);
    const std::vector<TexelRect> rects{{10, 10, 300, 20}, {0, 20, 300, 90}, {5000, 0, 5001, 1}};
    EXPECT_EQ(without_overlaps(rects, grid), rects);
    EXPECT_TRUE(without_overlaps({}, grid).empty());
}

TEST(WithoutOverlaps, ARowOfDabsIsCoveredWithLittleBesideIt) {
    const TileGrid grid(8192, 8100);
    std::vector<TexelRect> dabs;
    for (int i = 0; i < 40; ++i) dabs.push_back({i * 50, 100 + i * 50, i * 50 + 200, 300 + i * 50});
    dabs.push_back({8000, 8000, 8192, 8100});
    const std::vector<TexelRect> rects = without_overlaps(dabs, grid);
    EXPECT_TRUE(disjoint(rects));
    EXPECT_LE(rects.size(), 64u);
    std::int64_t area = 0, inside = 0, wanted = 0;
    for (const TexelRect& rect : rects) area += rect.area();
    for (const TexelRect& dab : dabs)
        for (int y = dab.y0; y < dab.y1; ++y)
            for (int x = dab.x0; x < dab.x1; ++x) {
                ++wanted;
                inside += std::any_of(rects.begin(), rects.end(), [&](const TexelRect& r) { return r.contains(x, y); });
            }
    EXPECT_EQ(inside, wanted);
    EXPECT_LT(area, 40 * 200 * 200);  // what all dabs hold, one by one
}

}  // namespace
}  // namespace relievo::rect_test
