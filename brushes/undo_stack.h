// Undo and redo under a byte budget. A step holds, for each 64 x 64 tile that a stroke changed, the changed
// rectangle's texels on the other side of the step; applying it swaps them with the map's, which turns undo
// into redo and back.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "brushes/height_map.h"
#include "brushes/stroke_tiles.h"
#include "brushes/texel_rect.h"

namespace relievo {

class UndoStack {
  public:
    explicit UndoStack(std::size_t budget) : budget_(budget) {}

    // Takes the before-images of a finished stroke as one step, if it changed anything; redo is dropped then.
    void push(const StrokeTiles& stroke, const HeightMap& map);

    bool can_undo() const { return !undo_.empty(); }
    bool can_redo() const { return !redo_.empty(); }
    // The rectangles that changed, one a tile; none where there is no step.
    std::vector<TexelRect> undo(HeightMap& map) { return move_step(undo_, redo_, map); }
    std::vector<TexelRect> redo(HeightMap& map) { return move_step(redo_, undo_, map); }

    std::uint64_t pushed() const { return pushed_; }  // steps ever taken, dropped ones included
    std::size_t bytes() const { return bytes_; }
    std::size_t budget() const { return budget_; }

  private:
    struct Patch {
        TexelRect rect;
        std::vector<std::uint16_t> texels;
    };
    struct Step {
        std::vector<Patch> patches;
        std::size_t bytes = 0;
    };
    static std::vector<TexelRect> move_step(std::deque<Step>& from, std::deque<Step>& to, HeightMap& map);

    std::uint64_t pushed_ = 0;
    std::size_t budget_, bytes_ = 0;
    std::deque<Step> undo_, redo_;  // newest last
};

}  // namespace relievo
