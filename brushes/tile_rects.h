// What several edits changed, as rectangles that do not overlap.
#pragma once

#include <span>
#include <vector>

#include "brushes/stroke_tiles.h"
#include "brushes/texel_rect.h"

namespace relievo {

// Cuts `rects` at the borders of the grid's tiles and makes those of a tile one. In the order of the tiles; empty ones
// are dropped.
std::vector<TexelRect> joined_by_tile(std::span<const TexelRect> rects, const TileGrid& grid);

// `rects` where none overlaps another, else rectangles that do not, at most one a run of tiles that they touch in a row,
// with all their texels and some between.
std::vector<TexelRect> without_overlaps(std::vector<TexelRect> rects, const TileGrid& grid);

}  // namespace relievo
