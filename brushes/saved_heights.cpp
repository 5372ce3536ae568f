// See saved_heights.h.
#include "brushes/saved_heights.h"

namespace relievo {

void SavedHeights::mark_saved() {
    for (auto& tile : tiles_) tile.reset();
}

void SavedHeights::keep(const StrokeTiles& ended) {
    for (const std::uint32_t index : ended.touched()) {
        const StrokeTiles::Tile& tile = *ended.tile(index);
        if (tiles_[index] || tile.ever_dirty.empty()) continue;
        tiles_[index] = std::make_unique<TileCounts>(tile.before);
    }
}

void SavedHeights::keep(const TexelRect& rect) {
    if (rect.empty()) return;
    for (int y = rect.y0 - rect.y0 % kTileSize; y < rect.y1; y += kTileSize)
        for (int x = rect.x0 - rect.x0 % kTileSize; x < rect.x1; x += kTileSize) {
            const std::uint32_t index = grid_.tile_of(x, y);
            if (tiles_[index]) continue;
            tiles_[index] = std::make_unique<TileCounts>();
            copy_counts(map_, grid_.texels_of(index), *tiles_[index]);
        }
}

}  // namespace relievo
