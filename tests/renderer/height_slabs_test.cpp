// Bounds of heights about planes: true for every stretch that begins in a node, close where a map is smooth, and after
// edits changed in no node but those that the pyramid names.
#include "renderer/height_slabs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/scenes.h"

namespace relievo::test::height_slabs_test {
namespace {

template <typename Height>
TestMap counts_map(int width, int height, const Height& of) {
    TestMap map{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            map.texels.push_back(static_cast<std::uint16_t>(std::clamp(of(x, y), 0.0, 65535.0)));
    return map;
}

struct Size {
    int width, height;
};
constexpr Size kSizes[] = {{1, 1}, {1, 9}, {9, 1}, {7, 5}, {64, 64}, {100, 37}, {31, 63}, {300, 40}};
constexpr Wrap kWraps[] = {Wrap::repeat, Wrap::clamp};

std::vector<TestMap> maps_of(const Size& size, std::mt19937& rng) {
    const auto [w, h] = size;
    return {counts_map(w, h, [&](int, int) { return double(rng() & 0xffffu); }),
            counts_map(w, h, [&](int x, int y) { return 32768 + 30000 * std::sin(6.2832 * x / w) * std::cos(6.2832 * y / h); }),
            counts_map(w, h, [&](int x, int y) { return 700.0 * x + 300.0 * y; }),
            counts_map(w, h, [&](int x, int y) { return 65535 - 1500.0 * x + 90.0 * (y % 7); }),
            counts_map(w, h, [&](int x, int y) { return (x / 3 + y / 5) % 2 == 0 ? 0.0 : 65535.0; })};
}

// Heights over the slab's plane at the texels of all stretches that begin in the cell, which may lie beyond the map.
void expect_holds(const TestMap& map, const HeightPyramid& pyramid, int level, int cx, int cy) {
    const Wrap wrap = pyramid.wrap();
    const int x = wrapped(cx, map.width, wrap), y = wrapped(cy, map.height, wrap);
    const int i = std::min(x >> level, pyramid.width(level) - 1), j = std::min(y >> level, pyramid.height(level) - 1);
    const PackedSlab slab = height_slab(map.view(), pyramid, level, i, j);
    for (int v = 0; v <= (1 << level) + 1; ++v)
        for (int u = 0; u <= (1 << level) + 1; ++u) {
            const int at = wrapped(cy + v, map.height, wrap) * map.width + wrapped(cx + u, map.width, wrap);
            const double across = x + u - ((i + 1) << level), up = y + v - ((j + 1) << level);
            const double over = map.texels[static_cast<std::size_t>(at)] -
                                (across * slab.rise_x + up * slab.rise_y) / (1 << level);
            ASSERT_GE(over, slab.low + 32768) << "level " << level << " cell " << cx << " " << cy;
            ASSERT_LE(over, slab.high + 32768) << "level " << level << " cell " << cx << " " << cy;
        }
}

TEST(HeightSlabs, HoldEveryStretchThatBeginsInTheirNode) {
    std::mt19937 rng(31);
    for (const Wrap wrap : kWraps)
        for (const Size& size : kSizes)
            for (const TestMap& map : maps_of(size, rng)) {
                const HeightPyramid pyramid(map.view(), wrap);
                const int cells = size.width * size.height, step = std::max(1, cells / 150);
                for (int level = 1; level <= pyramid.levels(); ++level) {
                    for (int k = static_cast<int>(rng() % unsigned(step)); k < cells; k += step)
                        ASSERT_NO_FATAL_FAILURE(expect_holds(map, pyramid, level, k % size.width, k / size.width));
                    for (const int beyond : {-5, size.width + 3})
                        ASSERT_NO_FATAL_FAILURE(expect_holds(map, pyramid, level, beyond, size.height / 2));
                    for (const int beyond : {-5, size.height + 3})
                        ASSERT_NO_FATAL_FAILURE(expect_holds(map, pyramid, level, size.width / 2, beyond));
                }
            }
}

TEST(HeightSlabs, AreClosedOverARampAndCloseOverASmoothMap) {
    const TestMap ramp = counts_map(256, 256, [](int x, int y) { return 100.0 * x + 50.0 * y; });
    const TestMap waves = counts_map(1024, 1024, [](int x, int y) {
        return 32768 + 20000 * std::sin(6.2832 * x / 256) * std::cos(6.2832 * y / 256);
    });
    const HeightPyramid of_ramp(ramp.view(), Wrap::clamp), of_waves(waves.view(), Wrap::repeat);
    for (int level = 1; level <= 6; ++level) {
        const int middle = of_ramp.width(level) / 2 - 1;
        const PackedSlab slab = height_slab(ramp.view(), of_ramp, level, middle, middle);
        // Above level 3 a part's own range, of the plane's slopes, is added twice, and rounding.
        const int parts = level <= 3 ? 0 : 2 * 150 * (1 << (level - 3)) + 1;
        EXPECT_LE(slab.high - slab.low, 1 + parts) << level;
    }
    for (int level = 1; level <= 4; ++level) {
        double about_planes = 0, heights = 0;
        for (int y = 0; y < of_waves.height(level); ++y)
            for (int x = 0; x < of_waves.width(level); ++x) {
                const PackedSlab slab = height_slab(waves.view(), of_waves, level, x, y);
                const HeightPyramid::Node node = of_waves.overlapping(level, x, y);
                about_planes += slab.high - slab.low;
                heights += node.high - node.low;
            }
        EXPECT_LT(about_planes, heights * (level == 4 ? 0.6 : 0.25)) << level;
    }
}

TEST(HeightSlabs, AnEditChangesNoNodeButThoseThatThePyramidNames) {
    std::mt19937 rng(32);
    for (const Wrap wrap : kWraps)
        for (const Size& size : kSizes)
            for (TestMap& map : maps_of(size, rng)) {
                HeightPyramid live(map.view(), wrap);
                for (int round = 0; round < 4; ++round) {
                    const TestMap old = map;
                    const HeightPyramid before = live;
                    const int x0 = int(rng() % unsigned(size.width)), y0 = int(rng() % unsigned(size.height));
                    const TexelRegion r{x0, y0, std::min(x0 + 1 + int(rng() % 9), size.width),
                                        std::min(y0 + 1 + int(rng() % 9), size.height)};
                    for (int y = r.y0; y < r.y1; ++y)
                        for (int x = r.x0; x < r.x1; ++x)
                            map.texels[static_cast<std::size_t>(y * size.width + x)] = static_cast<std::uint16_t>(rng());
                    const auto changed = live.update(map.view(), r);
                    for (int level = 1; level <= live.levels(); ++level)
                        for (int y = 0; y < live.height(level); ++y)
                            for (int x = 0; x < live.width(level); ++x) {
                                const bool named = std::any_of(changed.begin(), changed.end(), [&](const auto& n) {
                                    return n.level == level && x >= n.x0 && x < n.x1 && y >= n.y0 && y < n.y1;
                                });
                                if (named) continue;
                                const PackedSlab a = height_slab(old.view(), before, level, x, y);
                                const PackedSlab b = height_slab(map.view(), live, level, x, y);
                                ASSERT_TRUE(a.low == b.low && a.high == b.high && a.rise_x == b.rise_x && a.rise_y == b.rise_y)
                                    << "level " << level << " node " << x << " " << y;
                            }
                }
            }
}

}  // namespace
}  // namespace relievo::test::height_slabs_test
