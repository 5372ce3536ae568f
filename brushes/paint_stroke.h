// The colour side of a stroke: what its dabs blend into the colour map.
//
// Paper 002 (section 6, editing) blends a brush into displacement and colour maps alike. Ours blends in
// sRGB-encoded values, as painting programs do: equal steps look equal. Where the brush accumulates, a dab
// takes a texel the fraction w * spacing / kUnitSpacing (at most 1) of the way from the colour it has by now
// to the brush's, w = strength * pressure * falloff, less by what the mask protects. Where it does not (of
// the tools that ask: draw, inflate, noise), and for level, a stroke takes it the largest w of the way from
// the colour that the stroke found, by the distance from the way since the last dab (dab_trail.h). Copies by
// symmetry count once where they overlap: the largest w. Colours are kept in float through a stroke and
// quantised once. Smooth does to each channel what it does to heights.
// Stamp paints through its image: w times the image's value, from 0 to 1; where it accumulates, every press is
// a whole one.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brushes/brush.h"
#include "brushes/colour_map.h"
#include "brushes/seams.h"
#include "brushes/stroke_tiles.h"
#include "brushes/surface.h"

namespace relievo {

class Alpha;

class PaintStroke {
  public:
    // All outlive the stroke. `alpha`: of stamp; else null.
    PaintStroke(const Brush& brush, const Alpha* alpha, ColourMap& map, const Seams& seams);

    struct Place {
        const Surface& surface;  // as the hand, or the copy, sees it
        SurfacePoint centre;     // in that frame
        float radius;            // of the dab, world units
        glm::vec3 motion;        // from the last dab, as DabPlace has it
        glm::vec3 right;         // of stamp's image (pressed_image.h)
    };
    // One dab with its copies, `at_once` of them in work at a time (dab_cost.h). `pressure` in [0, 1]; `mask`:
    // 65535 protects a texel, null: none.
    void dab(std::span<const Place> places, float pressure, const HeightMap* mask, std::size_t at_once);
    // At the stroke's end: slanted seams.
    void settle(const HeightMap* mask);

    // One rectangle for each tile in which a channel changed since the last call.
    std::vector<TexelRect> take_dirty();
    // Puts the colours from before the stroke back. One rectangle for each tile that changed.
    std::vector<TexelRect> restore();

    const StrokeTiles& plane(std::size_t channel) const { return *planes_[channel]; }

  private:
    struct Weight {
        std::int32_t x, y;
        float of_way;  // [0, 1]
    };
    static std::vector<Weight> merged(const std::vector<Weight>& a, const std::vector<Weight>& b);
    std::vector<Weight> weights(std::span<const Place> places, float pressure, const HeightMap* mask,
                                std::size_t at_once) const;

    void smooth_planes(std::span<const Place> places, float pressure, const HeightMap* mask,
                       std::size_t at_once);

    const Brush& brush_;
    const Alpha* alpha_;
    const Seams& seams_;
    bool piles_up_;
    float part_of_pass_;  // that a dab of full weight is, where they pile up
    std::array<float, 3> colour_;  // counts
    std::array<std::unique_ptr<StrokeTiles>, 3> planes_;
};

}  // namespace relievo
