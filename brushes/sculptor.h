// Applies strokes to a height map on a surface: float accumulation, one quantisation, seams, undo tiles.
#pragma once

#include <memory>
#include <vector>

#include "brushes/brush.h"
#include "brushes/height_map.h"
#include "brushes/surface.h"
#include "brushes/texel_rect.h"

namespace relievo {

class Sculptor {
  public:
    // `map` and `surface` outlive the sculptor. The surface reads the same map. `undo_budget` in bytes: the oldest
    // steps are dropped when the tiles of undo and redo together exceed it.
    Sculptor(HeightMap& map, const Surface& surface, std::size_t undo_budget = std::size_t{512} << 20);
    ~Sculptor();

    // A stroke: begin, dabs, then end (one undo step) or cancel (leaves no trace). Each call returns the texels that
    // changed, as few rectangles that do not overlap (islands far apart stay apart). A dab on a face that does not
    // exist throws std::out_of_range.
    void begin(const Brush& brush);
    std::vector<TexelRect> dab(const Dab& dab);
    std::vector<TexelRect> end();
    std::vector<TexelRect> cancel();
    bool in_stroke() const;

    bool can_undo() const;
    bool can_redo() const;
    std::vector<TexelRect> undo();  // nothing to undo: empty
    std::vector<TexelRect> redo();
    std::size_t undo_bytes() const;   // held by undo and redo tiles now
    std::size_t undo_budget() const;

    // Texels at count 0 or 65535 that a stroke tried to push further since begin(): the editor's clip warning.
    std::size_t clipped_texels() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace relievo
