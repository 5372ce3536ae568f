// Which tiles are traced next.
#include "editor/gui/stale_tiles.h"

#include <gtest/gtest.h>

namespace relievo::gui::stale_tiles_test {
namespace {

constexpr int kTile = StaleTiles::kTile;

bool holds(const PixelRect& r, double x, double y) {
    return x >= r.x0 && x < r.x1 && y >= r.y0 && y < r.y1;
}

TEST(StaleTiles, TheDabUnderTheBrushComesBeforeTheRestOfItsWindow) {
    StaleTiles tiles;
    tiles.reset(1000, 700);
    tiles.clear({0, 0, 1000, 700});
    EXPECT_EQ(tiles.count(), 0);
    tiles.mark({300, 300, 556, 556}, StaleTiles::late);
    tiles.mark({420, 420, 440, 440}, StaleTiles::urgent);
    tiles.mark({300, 300, 556, 556}, StaleTiles::late);  // which makes nothing less urgent
    EXPECT_EQ(tiles.urgent_count(), 1);
    const PixelRect first = tiles.next({310, 310}, kTile * kTile);
    EXPECT_TRUE(holds(first, 430, 430));
    tiles.clear(first);
    EXPECT_EQ(tiles.urgent_count(), 0);
    EXPECT_TRUE(holds(tiles.next({310, 310}, kTile * kTile), 310, 310));
}

TEST(StaleTiles, PicturesOfAnySizeAreTracedWholeAndOnce) {
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(31, 65), std::pair(333, 200)}) {
        StaleTiles tiles;
        tiles.reset(width, height);
        long traced = 0;
        for (int steps = 0; tiles.count() > 0; ++steps) {
            ASSERT_LT(steps, 1000);
            const PixelRect r = tiles.next({width * 0.5, height * 0.5}, 5 * kTile * kTile);
            ASSERT_LE(r.x1, width);
            ASSERT_LE(r.y1, height);
            traced += static_cast<long>(r.x1 - r.x0) * (r.y1 - r.y0);
            tiles.clear(r);
        }
        EXPECT_EQ(traced, static_cast<long>(width) * height);
        EXPECT_EQ(tiles.fresh_share(), 1);
    }
}

TEST(StaleTiles, MarksOutsideThePictureAreCut) {
    StaleTiles tiles;
    tiles.reset(100, 100);
    tiles.clear({0, 0, 100, 100});
    tiles.mark({-500, -500, -10, 400}, StaleTiles::urgent);
    tiles.mark({120, 20, 900, 60}, StaleTiles::urgent);
    EXPECT_EQ(tiles.count(), 0);
    tiles.mark({-500, 90, 5000, 95}, StaleTiles::urgent);
    EXPECT_EQ(tiles.urgent_count(), 4);
}

TEST(StaleTiles, AHalfTracedTileStaysStale) {
    StaleTiles tiles;
    tiles.reset(2 * kTile, kTile);
    tiles.clear({0, 0, kTile + 1, kTile});
    EXPECT_EQ(tiles.count(), 1);
    EXPECT_TRUE(tiles.stale_at(1, 0));
}

}  // namespace
}  // namespace relievo::gui::stale_tiles_test
