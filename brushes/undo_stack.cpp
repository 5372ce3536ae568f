// Undo steps: made from a stroke's tiles, applied by swapping.
#include "brushes/undo_stack.h"

#include <algorithm>
#include <utility>

namespace relievo {

UndoStack::Rows UndoStack::rows_of(const HeightMap& map, const TexelRect& rect) {
    return {&map.texels()[map.index(rect.x0, rect.y0)], static_cast<std::size_t>(map.width()), rect.width(), rect.height()};
}

bool UndoStack::Rows::are_even() const {
    bool even = std::equal(first + 1, first + width, first);
    for (int y = 1; even && y < height; ++y) even = std::equal(first, first + width, row(y));
    return even;
}

std::vector<std::uint16_t> UndoStack::Rows::texels() const {
    if (are_even()) return {*first};
    std::vector<std::uint16_t> all;
    all.reserve(count());
    for (int y = 0; y < height; ++y) all.insert(all.end(), row(y), row(y) + width);
    return all;
}

// Only the part of `within` whose texels differ from those before: what a wandering stroke changed and
// changed back, or never rounded to another count, needs no memory.
void UndoStack::add_patch(Step& step, Layer layer, const TexelRect& within, const HeightMap& map, const Rows& before) {
    const Rows now = rows_of(map, within);
    Patch patch{layer, {}, {}};
    for (int y = 0; y < now.height; ++y) {
        const std::uint16_t *a = now.row(y), *b = before.row(y);
        if (std::equal(a, a + now.width, b)) continue;
        int x0 = 0, x1 = now.width;
        while (a[x0] == b[x0]) ++x0;
        while (a[x1 - 1] == b[x1 - 1]) --x1;
        patch.rect.include({within.x0 + x0, within.y0 + y, within.x0 + x1, within.y0 + y + 1});
    }
    const TexelRect& rect = patch.rect;
    if (rect.empty()) return;
    const std::uint16_t* const first = before.row(rect.y0 - within.y0) + (rect.x0 - within.x0);
    const Rows there{first, before.stride, rect.width(), rect.height()};
    patch.texels = there.texels();
    const bool even = patch.texels.size() == 1 && rows_of(map, rect).are_even();
    step.bytes += kPatchBytes + (even ? 1 : there.count()) * sizeof(std::uint16_t);
    step.patches.push_back(std::move(patch));
}

void UndoStack::push(std::span<const LayerStroke> strokes) {
    Step step;
    for (const auto& [stroke, map, layer] : strokes)
        for (const std::uint32_t index : stroke.touched()) {
            const StrokeTiles::Tile& tile = *stroke.tile(index);
            const TexelRect& within = tile.ever_dirty;
            if (within.empty()) continue;
            const std::uint16_t* const first = &tile.before[place_in_tile(within.x0, within.y0)];
            add_patch(step, layer, within, map, {first, kTileSize, within.width(), within.height()});
        }
    push_step(std::move(step));
}

void UndoStack::push(const HeightMap& before, const HeightMap& map, Layer layer, const Advance& advance) {
    constexpr std::uint32_t kTiles = 1024;  // between two times that it is told: some hundredths of a second
    Step step;
    const TileGrid grid(map.width(), map.height());
    for (std::uint32_t tile = 0; tile < grid.count(); ++tile) {
        if (tile % kTiles == 0) tell(advance, tile / static_cast<double>(grid.count()), "Stopped: all is as it was");
        const TexelRect texels = grid.texels_of(tile);
        add_patch(step, layer, texels, map, rows_of(before, texels));
    }
    push_step(std::move(step));
}

void UndoStack::push_step(Step step) {
    if (step.patches.empty()) return;

    for (const Step& dropped : redo_) bytes_ -= dropped.bytes;
    redo_.clear();
    ++pushed_;
    bytes_ += step.bytes;
    undo_.push_back(std::move(step));
    while (bytes_ > budget_) {
        bytes_ -= undo_.front().bytes;
        undo_.pop_front();
    }
}

std::vector<LayerRect> UndoStack::rects_of(const std::deque<Step>& steps) {
    std::vector<LayerRect> rects;
    if (steps.empty()) return rects;
    for (const Patch& patch : steps.back().patches) rects.push_back({patch.layer, patch.rect});
    return rects;
}

void UndoStack::swap(Patch& patch, HeightMap& map) {
    const TexelRect& rect = patch.rect;
    std::vector<std::uint16_t> other = rows_of(map, rect).texels();
    const bool even = patch.texels.size() == 1;
    auto from = patch.texels.begin();
    for (int y = rect.y0; y < rect.y1; ++y) {
        std::uint16_t* const row = &map.texels()[map.index(rect.x0, y)];
        if (even) {
            std::fill_n(row, rect.width(), *from);
        } else {
            std::copy_n(from, rect.width(), row);
            from += rect.width();
        }
    }
    patch.texels = std::move(other);
}

std::vector<LayerRect> UndoStack::move_step(std::deque<Step>& from, std::deque<Step>& to,
                                            const LayerMaps& map_of) {
    std::vector<LayerRect> rects;
    if (from.empty()) return rects;
    Step step = std::move(from.back());
    from.pop_back();
    for (Patch& patch : step.patches) {
        swap(patch, map_of(patch.layer));
        rects.push_back({patch.layer, patch.rect});
    }
    to.push_back(std::move(step));
    return rects;
}

}  // namespace relievo
