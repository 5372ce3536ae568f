// The min-max pyramid: after edits equal to a rebuild, its nodes true for every stretch that begins in them.
#include "renderer/height_pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/scenes.h"

namespace relievo::test::height_pyramid_test {
namespace {

TestMap noise(int width, int height, std::mt19937& rng) {
    TestMap map{width, height, {}};
    for (int i = 0; i < width * height; ++i)
        map.texels.push_back(static_cast<std::uint16_t>(rng() & 0xffffu));
    return map;
}

struct Size {
    int width, height;
};
constexpr Size kSizes[] = {{1, 1}, {1, 9}, {9, 1}, {7, 5}, {64, 64}, {100, 37}};

void expect_equal(const HeightPyramid& a, const HeightPyramid& b) {
    for (int level = 1; level <= a.levels(); ++level)
        for (int y = 0; y < a.height(level); ++y)
            for (int x = 0; x < a.width(level); ++x) {
                const HeightPyramid::Node na = a.overlapping(level, x, y), nb = b.overlapping(level, x, y);
                ASSERT_EQ(na.low, nb.low) << "level " << level << " node " << x << " " << y;
                ASSERT_EQ(na.high, nb.high) << "level " << level << " node " << x << " " << y;
            }
}

TEST(HeightPyramid, RandomEditsEqualARebuildAndNameAllThatChanged) {
    std::mt19937 rng(11);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (const Size& size : kSizes) {
            TestMap map = noise(size.width, size.height, rng);
            HeightPyramid live(map.view(), wrap);
            for (int round = 0; round < 40; ++round) {
                const int x0 = int(rng() % unsigned(size.width)), y0 = int(rng() % unsigned(size.height));
                const TexelRegion r{x0, y0, x0 + 1 + int(rng() % unsigned(size.width - x0)),
                                    y0 + 1 + int(rng() % unsigned(size.height - y0))};
                const std::uint16_t level = static_cast<std::uint16_t>(rng() & 0xffffu);
                for (int y = r.y0; y < r.y1; ++y)
                    for (int x = r.x0; x < r.x1; ++x)
                        map.texels[static_cast<std::size_t>(y * size.width + x)] = level;
                const HeightPyramid before = live;
                const auto changed = live.update(map.view(), r);
                expect_equal(live, HeightPyramid(map.view(), wrap));
                // What was not named is as it was.
                for (int l = 1; l <= live.levels(); ++l)
                    for (int y = 0; y < live.height(l); ++y)
                        for (int x = 0; x < live.width(l); ++x) {
                            const bool named =
                                std::any_of(changed.begin(), changed.end(), [&](const auto& n) {
                                    return n.level == l && x >= n.x0 && x < n.x1 && y >= n.y0 && y < n.y1;
                                });
                            if (named) continue;
                            ASSERT_EQ(live.overlapping(l, x, y).low, before.overlapping(l, x, y).low);
                            ASSERT_EQ(live.overlapping(l, x, y).high, before.overlapping(l, x, y).high);
                        }
            }
        }
}

// A stretch that begins anywhere in cell c and is 2^level long ends in cell c + 2^level at the latest.
TEST(HeightPyramid, ANodeHoldsEveryStretchThatBeginsInIt) {
    std::mt19937 rng(12);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (const Size& size : kSizes) {
            const TestMap map = noise(size.width, size.height, rng);
            const HeightPyramid pyramid(map.view(), wrap);
            for (int level = 1; level <= pyramid.levels(); ++level)
                for (int cy = 0; cy < size.height; ++cy)
                    for (int cx = 0; cx < size.width; ++cx) {
                        const HeightPyramid::Node node =
                            pyramid.overlapping(level, std::min(cx >> level, pyramid.width(level) - 1),
                                                std::min(cy >> level, pyramid.height(level) - 1));
                        for (int y = cy; y <= cy + (1 << level) + 1; ++y)
                            for (int x = cx; x <= cx + (1 << level) + 1; ++x) {
                                const int at =
                                    wrapped(y, size.height, wrap) * size.width + wrapped(x, size.width, wrap);
                                const std::uint16_t texel = map.texels[static_cast<std::size_t>(at)];
                                ASSERT_LE(node.low, texel) << level << " " << cx << " " << cy;
                                ASSERT_GE(node.high, texel) << level << " " << cx << " " << cy;
                            }
                    }
        }
}

// Counted in nodes, not in time: what an edit reduces does not grow with the map.
TEST(HeightPyramid, AnEditOfALargeMapTouchesNoMoreThanOfASmallOne) {
    const auto nodes_after_edit = [](int size) {
        const TestMap map{size, size,
                      std::vector<std::uint16_t>(static_cast<std::size_t>(size) * std::size_t(size), 9)};
        HeightPyramid pyramid(map.view(), Wrap::repeat);
        std::int64_t nodes = 0;
        const int at = size / 2 - 128;
        for (const auto& n : pyramid.update(map.view(), {at, at, at + 256, at + 256}))
            nodes += std::int64_t{n.x1 - n.x0} * (n.y1 - n.y0);
        return nodes;
    };
    EXPECT_EQ(nodes_after_edit(4096), nodes_after_edit(1024));
}

}  // namespace
}  // namespace relievo::test::height_pyramid_test
