// Tiles of a stroke under way: created on first touch, written through to the map.
#include "brushes/stroke_tiles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo {
void copy_counts(const HeightMap& map, const TexelRect& tile, TileCounts& counts) {
    for (int row = tile.y0; row < tile.y1; ++row)
        std::copy_n(map.texels().begin() + static_cast<std::ptrdiff_t>(map.index(tile.x0, row)), tile.width(),
                    counts.begin() + (row - tile.y0) * kTileSize);
}

StrokeTiles::Tile& StrokeTiles::touch(std::uint32_t index) {
    if (!tiles_[index]) {
        auto tile = std::make_unique<Tile>();
        tile->change.fill(0.0f);
        copy_counts(map_, grid_.texels_of(index), tile->before);
        tiles_[index] = std::move(tile);
        touched_.push_back(index);
    }
    return *tiles_[index];
}

void StrokeTiles::write(Tile& tile, std::uint32_t index, int x, int y, std::uint16_t count) {
    if (map_.at(x, y) == count) return;
    map_.set(x, y, count);
    if (tile.dirty.empty()) dirty_.push_back(index);
    tile.dirty.include(x, y);
}

void StrokeTiles::set_change(int x, int y, float change) {
    const std::uint32_t index = grid_.tile_of(x, y);
    Tile& tile = touch(index);
    const std::size_t at = place_in_tile(x, y);
    const float before = static_cast<float>(tile.before[at]);
    if (std::isnan(change)) return;
    float held = change;
    if (before + change > kTop || before + change < 0.0f) {
        held = before + change < 0.0f ? -before : kTop - before;
        tile.clipped.set(at);
    }
    tile.change[at] = held;
    // None is negative: truncation is floor, which is a call on plain x86-64.
    const int count = step_ == 1 ? static_cast<int>(before + held + 0.5f)
                                 : step_ * static_cast<int>((before + held) / static_cast<float>(step_) + 0.5f);
    write(tile, index, x, y, static_cast<std::uint16_t>(count));
}

void StrokeTiles::copy(int from_x, int from_y, int to_x, int to_y, int shift) {
    const float from = std::clamp(value(from_x, from_y) + static_cast<float>(shift), 0.0f, kTop);
    const auto count = static_cast<std::uint16_t>(map_.at(from_x, from_y) + shift);
    if (value(to_x, to_y) == from && map_.at(to_x, to_y) == count) return;
    const std::uint32_t index = grid_.tile_of(to_x, to_y);
    Tile& tile = touch(index);
    const std::size_t at = place_in_tile(to_x, to_y);
    tile.change[at] = from - static_cast<float>(tile.before[at]);
    write(tile, index, to_x, to_y, count);
}

std::vector<TexelRect> StrokeTiles::take_dirty() {
    std::vector<TexelRect> rects;
    rects.reserve(dirty_.size());
    for (const std::uint32_t index : dirty_) {
        Tile& tile = *tiles_[index];
        rects.push_back(tile.dirty);
        tile.ever_dirty.include(std::exchange(tile.dirty, {}));
    }
    dirty_.clear();
    return rects;
}

std::size_t StrokeTiles::clipped_texels() const {
    std::size_t sum = 0;
    for (const std::uint32_t index : touched_) sum += tiles_[index]->clipped.count();
    return sum;
}

std::vector<TexelRect> StrokeTiles::restore() {
    std::vector<TexelRect> rects;
    for (const std::uint32_t index : touched_) {
        const Tile& tile = *tiles_[index];
        TexelRect dirty = tile.ever_dirty;
        dirty.include(tile.dirty);
        for (int y = dirty.y0; y < dirty.y1; ++y)
            for (int x = dirty.x0; x < dirty.x1; ++x) map_.set(x, y, tile.before[place_in_tile(x, y)]);
        rects.push_back(dirty);
    }
    tiles_.clear();
    tiles_.resize(grid_.count());
    touched_.clear();
    dirty_.clear();
    return rects;
}

}  // namespace relievo
