// See tile_rects.h.
#include "brushes/tile_rects.h"

#include <algorithm>
#include <map>

namespace relievo {

std::vector<TexelRect> joined_by_tile(std::span<const TexelRect> rects, const TileGrid& grid) {
    std::map<std::uint32_t, TexelRect> of_tile;
    for (const TexelRect& rect : rects)
        for (int y = rect.y0; y < rect.y1; y += kTileSize - y % kTileSize)
            for (int x = rect.x0; x < rect.x1; x += kTileSize - x % kTileSize) {
                const std::uint32_t tile = grid.tile_of(x, y);
                const TexelRect texels = grid.texels_of(tile);
                of_tile[tile].include({x, y, std::min(rect.x1, texels.x1), std::min(rect.y1, texels.y1)});
            }
    std::vector<TexelRect> joined;
    for (const auto& [tile, rect] : of_tile) joined.push_back(rect);
    return joined;
}

namespace {

// Of tiles in order: those side by side become one. Not more than these: a row of dabs aslant would be its bounding
// square.
std::vector<TexelRect> joined_by_row(std::span<const TexelRect> tiles) {
    std::vector<TexelRect> rows;
    for (const TexelRect& tile : tiles) {
        const bool beside = !rows.empty() && rows.back().y0 / kTileSize == tile.y0 / kTileSize &&
                            (rows.back().x1 - 1) / kTileSize + 1 == tile.x0 / kTileSize;
        if (beside)
            rows.back().include(tile);
        else
            rows.push_back(tile);
    }
    return rows;
}

}  // namespace

std::vector<TexelRect> without_overlaps(std::vector<TexelRect> rects, const TileGrid& grid) {
    for (std::size_t i = 0; i < rects.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (rects[i].overlaps(rects[j])) return joined_by_row(joined_by_tile(rects, grid));
    return rects;
}

}  // namespace relievo
