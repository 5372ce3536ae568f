// What one dab of each tool does to the texels of its footprint. Every tool works on the stroke's float
// state.
//
// strength s, scaled by the pen's pressure, is honoured as follows (f is the falloff at the texel's 3D
// distance):
//   draw     raises by kDrawRise * radius * s * f * spacing world units, so that one straight pass at full
//   strength
//            and smooth falloff raises its middle by kDrawRise * radius whatever the spacing, and one dab by
//            at most kDrawRise * radius * spacing.
//   level,   move a texel the fraction s * f of the way from where the stroke found it to the target; passing
//   again erase    within the stroke adds nothing (the largest fraction counts), a second stroke goes on from
//   there. At
//            full strength, the middle of the brush arrives exactly.
//   smooth,  move a texel the fraction s * f * spacing / kUnitSpacing (at most 1) of the way to their target
//   at each flatten  dab, and so go on while the brush stays.
// No tool does anything where the amplitude is 0, not finite, or so small that a count has no size.
#pragma once

#include "brushes/brush.h"
#include "brushes/stroke_tiles.h"
#include "brushes/surface.h"

namespace relievo {

inline constexpr float kDrawRise = 0.5f;      // of the radius
inline constexpr float kUnitSpacing = 0.15f;  // of the radius

// The weight at `part` of the radius, both in [0, 1]: 1 up to `hardness`, 0 at the rim (but for constant).
float falloff_weight(Falloff falloff, float hardness, float part);

class Seams;

struct DabPlace {
    SurfacePoint centre;
    float pressure;  // [0, 1]
};

// Applies one dab. Reads `surface` (and by it the map as the last dab left it), writes `stroke`.
void apply_dab(const Brush& brush, const DabPlace& place, const Surface& surface, const Seams& seams,
               StrokeTiles& stroke);

}  // namespace relievo
