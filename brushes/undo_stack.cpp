// Undo steps: made from a stroke's tiles, applied by swapping.
#include "brushes/undo_stack.h"

#include <algorithm>
#include <utility>

namespace relievo {
namespace {

bool equal_within(const TexelRect& rect, const HeightMap& a, const HeightMap& b) {
    for (int y = rect.y0; y < rect.y1; ++y) {
        const std::uint16_t* const row = &a.texels()[a.index(rect.x0, y)];
        if (!std::equal(row, row + (rect.x1 - rect.x0), &b.texels()[b.index(rect.x0, y)])) return false;
    }
    return true;
}

}  // namespace

// Only the part of `within` whose texels differ from those before: what a wandering stroke changed and
// changed back, or never rounded to another count, needs no memory.
template <typename Before>
void UndoStack::add_patch(Step& step, Layer layer, const TexelRect& within, const HeightMap& map,
                          Before before) {
    Patch patch{layer, {}, {}};
    for (int y = within.y0; y < within.y1; ++y)
        for (int x = within.x0; x < within.x1; ++x)
            if (before(x, y) != map.at(x, y)) patch.rect.include(x, y);
    const TexelRect& rect = patch.rect;
    if (rect.empty()) return;
    patch.texels.reserve(static_cast<std::size_t>(rect.area()));
    for (int y = rect.y0; y < rect.y1; ++y)
        for (int x = rect.x0; x < rect.x1; ++x) patch.texels.push_back(before(x, y));
    step.bytes += kPatchBytes + patch.texels.size() * sizeof(std::uint16_t);
    step.patches.push_back(std::move(patch));
}

void UndoStack::push(std::span<const LayerStroke> strokes) {
    Step step;
    for (const auto& [stroke, map, layer] : strokes)
        for (const std::uint32_t index : stroke.touched())
            add_patch(step, layer, stroke.tile(index)->ever_dirty, map,
                      [&before = stroke](int x, int y) { return before.before(x, y); });
    push_step(std::move(step));
}

void UndoStack::push(const HeightMap& before, const HeightMap& map, Layer layer) {
    Step step;
    const TileGrid grid(map.width(), map.height());
    for (std::uint32_t tile = 0; tile < grid.count(); ++tile)
        if (const TexelRect texels = grid.texels_of(tile); !equal_within(texels, before, map))
            add_patch(step, layer, texels, map, [&](int x, int y) { return before.at(x, y); });
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

std::vector<LayerRect> UndoStack::move_step(std::deque<Step>& from, std::deque<Step>& to,
                                            const LayerMaps& map_of) {
    std::vector<LayerRect> rects;
    if (from.empty()) return rects;
    Step step = std::move(from.back());
    from.pop_back();
    for (Patch& patch : step.patches) {
        HeightMap& map = map_of(patch.layer);
        auto texel = patch.texels.begin();
        for (int y = patch.rect.y0; y < patch.rect.y1; ++y)
            for (int x = patch.rect.x0; x < patch.rect.x1; ++x, ++texel) {
                const std::uint16_t other = *texel;
                *texel = map.at(x, y);
                map.set(x, y, other);
            }
        rects.push_back({patch.layer, patch.rect});
    }
    to.push_back(std::move(step));
    return rects;
}

}  // namespace relievo
