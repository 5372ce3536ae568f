// Applies strokes to a height map on a surface, and to a colour map of its size: float accumulation, one
// quantisation, seams, undo tiles.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brushes/advance.h"
#include "brushes/alpha.h"
#include "brushes/brush.h"
#include "brushes/colour_map.h"
#include "brushes/height_map.h"
#include "brushes/surface.h"
#include "brushes/texel_rect.h"

namespace relievo {

class Sculptor {
  public:
    // `map` and `surface` outlive the sculptor. The surface reads the same map; its seams() are read once,
    // here. `undo_budget` in bytes: the oldest steps are dropped when the tiles of undo and redo together
    // exceed it, a step that alone exceeds it included.
    Sculptor(HeightMap& map, const Surface& surface, std::size_t undo_budget = std::size_t{512} << 20);
    ~Sculptor();

    // A stroke: begin, dabs, then end (one undo step; none if no texel changed) or cancel (leaves no trace).
    // Each call returns the texels that changed, as few rectangles that do not overlap (islands far apart
    // stay apart). begin() throws std::invalid_argument on a setting out of range. A dab on a face that does
    // not exist or at barycentrics outside it throws std::out_of_range and changes nothing. begin, undo and
    // redo inside a stroke, and dab, end and cancel outside one, throw std::logic_error.
    //
    // During a stroke the map is the rounded float state, and seam copies hold after every dab; the equations
    // of slanted seams are solved by end(), until when their outer texels merely extend the island. Memory of
    // a stroke: 25 KB for each 64 x 64 tile that it touches, and 75 KB where it paints.
    //
    // A stroke that paints (brush.h) changes the colour map as well or alone; take_painted() tells where.
    // begin() throws std::invalid_argument where there is no colour map.
    //
    // A stroke of the mask tool changes the mask alone: its calls return no rectangles.
    //
    // `alpha`: the image of a stroke of the stamp tool, which throws std::invalid_argument without.
    //
    // `copies`: where the copies of the dab lie that the brush's symmetry makes, one for each of
    // symmetry_copies() but the first (brushes/symmetry.h); another number throws std::out_of_range. All of a
    // dab's copies are worked out on the same state of the map, then applied together.
    //
    // `sources`: where the clone tool takes the relief from, for the dab itself and then for each of its
    // copies; none for other tools. Another number throws std::out_of_range.
    void begin(const Brush& brush, std::shared_ptr<const Alpha> alpha = {});
    std::vector<TexelRect> dab(const Dab& dab, std::span<const FacePoint> copies = {},
                               std::span<const FacePoint> sources = {});
    std::vector<TexelRect> end();
    std::vector<TexelRect> cancel();
    bool in_stroke() const;

    // The colour map that strokes paint, which outlives the sculptor. Throws std::invalid_argument where its
    // size is not the height map's, std::logic_error in a stroke or where there is one already.
    void set_colours(ColourMap& colours);
    // Texels of the colour map that changed since the last call, as few rectangles that do not overlap.
    std::vector<TexelRect> take_painted();

    // Steps of their own, like strokes. Throw std::logic_error in a stroke.
    // Of the map's size; gutter texels follow their sources. No undo step: what was there before the first.
    void set_mask(HeightMap mask);
    // Stopped, the three leave all as it was.
    void clear_mask(const Advance& advance = {});   // frees everything
    void invert_mask(const Advance& advance = {});  // protects what was free, and the other way round
    void blur_mask(const Advance& advance = {});    // softens its borders by a few texels, across islands
    // Counts: 65535 protects a texel from every tool but mask, 0 frees it. Null while nothing was ever
    // masked.
    const HeightMap* mask() const;
    std::uint64_t mask_revision() const;  // changes whenever mask() does

    // The height map as it is now is what erase goes back to where its brush says so; at first it is the one
    // that the sculptor was made with. Throws std::logic_error in a stroke.
    void mark_saved();

    bool can_undo() const;
    bool can_redo() const;
    std::vector<TexelRect> undo();  // the height map's; nothing to undo, or a step of mask or colour: empty
    std::vector<TexelRect> redo();
    std::uint64_t steps_made()
        const;  // strokes so far that changed texels, whether their step is still held or not
    std::size_t undo_bytes() const;  // held by undo and redo tiles now
    std::size_t undo_budget() const;

    // Texels at count 0 or 65535 that a stroke tried to push further since begin(), 0 after undo and
    // redo: the editor's clip warning.
    std::size_t clipped_texels() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace relievo
