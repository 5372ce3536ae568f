// The height map as it was last saved or loaded, for the erase tool. Kept by tiles: one is copied when an
// edit first changes it, so that what no edit has changed costs nothing, and all of it at most as much as the
// map.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "brushes/height_map.h"
#include "brushes/stroke_tiles.h"
#include "brushes/texel_rect.h"

namespace relievo {

class SavedHeights {
  public:
    // The map as it is now counts as saved. `map` outlives this.
    explicit SavedHeights(const HeightMap& map)
        : map_(map), grid_(map.width(), map.height()), tiles_(grid_.count()) {}
    void mark_saved();

    // Every edit of the map is told here: a stroke at its end, any other before it changes `rect`.
    void keep(const StrokeTiles& ended);
    void keep(const TexelRect& rect);

    // The saved count of a texel. `stroke`: of the map, under way or not told yet.
    std::uint16_t at(int x, int y, const StrokeTiles& stroke) const {
        const TileCounts* kept = tiles_[grid_.tile_of(x, y)].get();
        return kept ? (*kept)[place_in_tile(x, y)] : stroke.before(x, y);
    }

  private:
    const HeightMap& map_;
    TileGrid grid_;
    std::vector<std::unique_ptr<TileCounts>> tiles_;  // null: the map has not changed there since
};

}  // namespace relievo
