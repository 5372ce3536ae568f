// Undo and redo under a byte budget. A step holds, for each 64 x 64 tile that a stroke changed, the changed
// rectangle's texels on the other side of the step, or one where they are all equal, as over most of a mask;
// applying it swaps them with the map's, which turns undo into redo and back. Height map, mask and the planes of
// the colour map share one stack: steps are taken back in the order they were made, and a step that changed
// several of them is one.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <vector>

#include "brushes/advance.h"
#include "brushes/height_map.h"
#include "brushes/stroke_tiles.h"
#include "brushes/texel_rect.h"

namespace relievo {

enum class Layer : std::uint8_t { height, mask, red, green, blue };

// What a stroke changed of one layer.
struct LayerStroke {
    const StrokeTiles& stroke;
    const HeightMap& map;
    Layer layer;
};

// Texels of one layer that changed, within one tile.
struct LayerRect {
    Layer layer;
    TexelRect rect;
};

using LayerMaps = std::function<HeightMap&(Layer)>;

class UndoStack {
  public:
    explicit UndoStack(std::size_t budget) : budget_(budget) {}

    // Takes the before-images of a finished stroke as one step, if it changed anything; redo is dropped then.
    void push(std::span<const LayerStroke> strokes);
    // The same for a map that was changed as a whole. Requires equal sizes. Stopped, it takes nothing.
    void push(const HeightMap& before, const HeightMap& map, Layer layer, const Advance& advance = {});

    bool can_undo() const { return !undo_.empty(); }
    bool can_redo() const { return !redo_.empty(); }
    // What changed, one rectangle a tile of a layer; nothing where there is no step.
    std::vector<LayerRect> undo(const LayerMaps& map_of) { return move_step(undo_, redo_, map_of); }
    std::vector<LayerRect> redo(const LayerMaps& map_of) { return move_step(redo_, undo_, map_of); }

    // What the next of them would change, in the same way.
    std::vector<LayerRect> undo_rects() const { return rects_of(undo_); }
    std::vector<LayerRect> redo_rects() const { return rects_of(redo_); }

    std::uint64_t pushed() const { return pushed_; }  // steps ever taken, dropped ones included
    std::size_t bytes() const { return bytes_; }
    std::size_t budget() const { return budget_; }

  private:
    // Counted for a patch beside its texels. Fixed: a journal's replay must have the steps that its session had.
    static constexpr std::size_t kPatchBytes = 40;
    struct Patch {
        Layer layer;
        TexelRect rect;
        std::vector<std::uint16_t> texels;  // in rows, or one where all are equal
    };
    struct Step {
        std::vector<Patch> patches;
        std::size_t bytes = 0;  // on that side of it which takes more, so that undo and redo change nothing
    };
    // Texels of a rectangle, row by row, wherever they lie.
    struct Rows {
        const std::uint16_t* first;
        std::size_t stride;  // texels
        int width, height;
        const std::uint16_t* row(int y) const { return first + static_cast<std::size_t>(y) * stride; }
        std::size_t count() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
        bool are_even() const;
        std::vector<std::uint16_t> texels() const;  // as a patch holds them
    };
    static Rows rows_of(const HeightMap& map, const TexelRect& rect);
    static void add_patch(Step& step, Layer layer, const TexelRect& within, const HeightMap& map, const Rows& before);
    static void swap(Patch& patch, HeightMap& map);
    void push_step(Step step);
    static std::vector<LayerRect> rects_of(const std::deque<Step>& steps);
    static std::vector<LayerRect> move_step(std::deque<Step>& from, std::deque<Step>& to,
                                            const LayerMaps& map_of);

    std::uint64_t pushed_ = 0;
    std::size_t budget_, bytes_ = 0;
    std::deque<Step> undo_, redo_;  // newest last
};

}  // namespace relievo
