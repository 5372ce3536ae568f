// The state of a stroke under way: for every 64 x 64 tile that it touched, the texels before it and the
// change since in float. The map always shows before + change, rounded once; the change is never read back
// from the map, so a thousand dabs of 0.01 counts add up to 10. (As a change from the start, float keeps 1e-5
// of it.)
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <memory>
#include <vector>

#include "brushes/height_map.h"
#include "brushes/texel_rect.h"

namespace relievo {

inline constexpr int kTileSize = 64;  // texels a side; tiles at the upper and right border may be cut

// The tiles of a map in row-major order, and the texels of each.
class TileGrid {
  public:
    TileGrid(int width, int height)
        : width_(width),
          height_(height),
          across_((width + kTileSize - 1) / kTileSize),
          down_((height + kTileSize - 1) / kTileSize) {}

    std::uint32_t count() const { return static_cast<std::uint32_t>(across_ * down_); }
    TexelRect bounds() const { return {0, 0, width_, height_}; }
    std::uint32_t tile_of(int x, int y) const {
        return static_cast<std::uint32_t>((y / kTileSize) * across_ + x / kTileSize);
    }
    std::uint32_t tile_of(std::uint32_t texel) const {
        return tile_of(static_cast<int>(texel % static_cast<std::uint32_t>(width_)),
                       static_cast<int>(texel / static_cast<std::uint32_t>(width_)));
    }
    TexelRect texels_of(std::uint32_t tile) const {
        const int x = static_cast<int>(tile) % across_ * kTileSize,
                  y = static_cast<int>(tile) / across_ * kTileSize;
        return {x, y, std::min(x + kTileSize, width_), std::min(y + kTileSize, height_)};
    }

  private:
    int width_, height_, across_, down_;
};

// Counts of a tile, in rows of kTileSize; what lies outside the map is any number.
inline constexpr std::size_t kTileTexels = std::size_t{kTileSize} * kTileSize;
using TileCounts = std::array<std::uint16_t, kTileTexels>;
inline std::size_t place_in_tile(int x, int y) {
    return static_cast<std::size_t>(y % kTileSize) * kTileSize + static_cast<std::size_t>(x % kTileSize);
}
// `tile` as TileGrid::texels_of() says.
void copy_counts(const HeightMap& map, const TexelRect& tile, TileCounts& counts);

class StrokeTiles {
  public:
    struct Tile {
        TileCounts before;
        std::array<float, kTileTexels> change;  // counts
        std::bitset<kTileTexels> clipped;       // pushed beyond 0 or 65535
        TexelRect dirty;                        // map texels written since take_dirty()
        TexelRect ever_dirty;                   // up to take_dirty(), since the stroke began
    };

    // `step`: the map's texels are rounded to multiples of it.
    explicit StrokeTiles(HeightMap& map, int step = 1)
        : map_(map),
          step_(step),
          grid_(map.width(), map.height()),
          tiles_(grid_.count()) {}

    // Counts, unrounded, in [0, 65535].
    float value(int x, int y) const {
        const Tile* tile = tiles_[grid_.tile_of(x, y)].get();
        return tile
                   ? static_cast<float>(tile->before[place_in_tile(x, y)]) + tile->change[place_in_tile(x, y)]
                   : static_cast<float>(map_.at(x, y));
    }
    // The count before the stroke.
    std::uint16_t before(int x, int y) const {
        const Tile* tile = tiles_[grid_.tile_of(x, y)].get();
        return tile ? tile->before[place_in_tile(x, y)] : map_.at(x, y);
    }
    // The change since, 0 where nothing was written.
    float change(int x, int y) const {
        const Tile* tile = tiles_[grid_.tile_of(x, y)].get();
        return tile ? tile->change[place_in_tile(x, y)] : 0.0f;
    }

    // Sets the change of a texel, held to counts [0, 65535], and the map's rounded texel with it.
    void set_change(int x, int y, float change);
    void set_value(int x, int y, float value) { set_change(x, y, value - static_cast<float>(before(x, y))); }
    // The map's count now.
    std::uint16_t count(int x, int y) const { return map_.at(x, y); }
    // Makes one texel equal to another: the same unrounded value and the same count; or, with a shift that
    // keeps the count in the map's range, both so much higher.
    void copy(int from_x, int from_y, int to_x, int to_y, int shift = 0);

    const TileGrid& grid() const { return grid_; }
    const Tile* tile(std::uint32_t index) const { return tiles_[index].get(); }
    const std::vector<std::uint32_t>& touched() const {
        return touched_;
    }  // tile indices, in order of first touch

    // The tiles whose map texels changed since take_dirty(), which returns their dirty rectangles and forgets
    // them.
    const std::vector<std::uint32_t>& dirty() const { return dirty_; }
    std::vector<TexelRect> take_dirty();
    std::size_t clipped_texels() const;

    // Puts the texels from before the stroke back. The rectangles that changed.
    std::vector<TexelRect> restore();

  private:
    Tile& touch(std::uint32_t index);
    void write(Tile& tile, std::uint32_t index, int x, int y, std::uint16_t count);

    HeightMap& map_;
    int step_;
    TileGrid grid_;
    std::vector<std::unique_ptr<Tile>> tiles_;  // null: not touched
    std::vector<std::uint32_t> touched_, dirty_;
};

}  // namespace relievo
