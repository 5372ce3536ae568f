// Which parts of a picture show a surface that has changed since they were traced, and which of them to trace
// next: square tiles, the most urgent and nearest to where the user looks first.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "renderer/renderer.h"

namespace relievo::gui {

class StaleTiles {
  public:
    static constexpr int kTile = 32;  // pixels a side
    enum Level : std::uint8_t {
        fresh,
        late,   // its light may have changed, or nobody waits for it
        urgent  // the surface itself has changed under the brush
    };

    void reset(int width, int height);  // pixels; all tiles are late
    // Tiles that the window touches; none becomes less urgent.
    void mark(const PixelRect& window, Level level);
    void clear(const PixelRect& traced);  // tiles that it covers whole

    // Of the most urgent tiles the nearest to `focus` (pixels), with stale neighbours as long as the
    // rectangle has at most `most_pixels`; at least one tile. Call only while count() is not 0.
    PixelRect next(const glm::dvec2& focus, double most_pixels) const;

    int count() const { return count_; }  // stale ones
    int urgent_count() const { return urgent_count_; }
    double fresh_share() const;  // [0, 1]
    bool stale_at(int column, int row) const { return at(column, row) != fresh; }
    bool empty() const { return tiles_.empty(); }  // before the first reset()

  private:
    struct TileRect {  // half-open, tiles
        int x0, y0, x1, y1;
    };
    std::uint8_t at(int column, int row) const { return tiles_[index(column, row)]; }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }
    void set(int column, int row, Level level);
    TileRect nearest(const glm::dvec2& focus) const;
    bool all_stale(const TileRect& rect) const;
    PixelRect pixels(const TileRect& rect) const;

    int width_ = 0, height_ = 0;  // pixels
    int columns_ = 0, rows_ = 0;
    int count_ = 0, urgent_count_ = 0;
    std::vector<std::uint8_t> tiles_;  // Level, row by row
};

}  // namespace relievo::gui
