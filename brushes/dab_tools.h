// What one dab of each tool does to the texels of its footprint. Every tool works on the stroke's float
// state.
//
// strength s, scaled by the pen's pressure, is honoured as follows (f is the falloff at the texel's 3D
// distance, rise = kDrawRise * radius * s * f):
//   draw     raises by rise * spacing world units, so that one straight pass at full strength and smooth
//            falloff raises its middle by kDrawRise * radius whatever the spacing, and one dab by at most
//            kDrawRise * radius * spacing. Without accumulate, a stroke raises by rise, however often it
//            passes.
//   inflate  as draw, over the cosine between the relief's normal and the base's (at least kLeastCosine): the
//            relief moves along its own normal, so that slopes grow sideways. It is the normal of what is wider
//            than a quarter of the radius and than three texels, taken uphill (broad_slope.h).
//   noise    as draw, times a noise of [-1, 1] at the texel's place on the base mesh.
//   stamp    raises by rise times the image's value, at every dab: one press. Without accumulate, a stroke
//   raises
//            a texel by the most that any press wants. The image lies in the plane across the base normal at
//            the dab's centre, its longer side as wide as the brush, and is cut off by the falloff.
//   crease   lowers as draw by rise * spacing * f^2, and pinches half as much as pinch.
//   clay     moves what is below a plane towards it: the plane through the footprint, raised by what a dab of
//            draw at kUnitSpacing raises. Planes, flatten's too, are planes of the surface as it is shaded, with
//            the base mesh curved between its vertices: else the triangles of a coarse one would show.
//   level,   move a texel the fraction s * f of the way from where the stroke found it to the target; passing
//   erase    again within the stroke adds nothing (the largest fraction counts), a second stroke goes on from
//            there. At full strength, the middle of the brush arrives exactly.
//            erase: to the midlevel, or to the map as it was last saved (saved_heights.h).
//   smooth,  move a texel the fraction s * f * spacing / kUnitSpacing (at most 1) of the way to their target
//   flatten  at each dab, and so go on while the brush stays.
//   pinch    draws the relief in by kPinch * s * f * spacing / kUnitSpacing of its distance to the centre.
//   smear    carries the relief along with the hand, s * f of the way from the last dab.
//   mask     as level, on the mask: to 65535, protected; inverted, to 0. Its blur does as smooth, on the mask.
//   clone    moves a texel the fraction s * f of the way from where the stroke found it to what lay at the
//            source before the stroke, as level does. The plane across the base normal at the dab's centre is
//            laid on that at the source, turned as the dab says.
//   grab     moves what the first dab held by s * f of the hand's drag, its relief along the surface and its
//            height by the drag's part along the normal.
// Where the largest counts (level, erase, mask, clone; draw, inflate and noise without accumulate), the distance is that
// from the way since the last dab (dab_trail.h).
// What a stroke paints stands in brushes/paint_stroke.h; invert does not turn colours.
// invert turns draw, stamp, inflate, noise, clay, crease, pinch and mask round. Where the mask protects a
// texel, s is less by as much. No tool but mask does anything where the amplitude is 0, not finite, or so
// small that a count has no size.
#pragma once

#include <memory>
#include <vector>

#include "brushes/brush.h"
#include "brushes/stroke_tiles.h"
#include "brushes/surface.h"

namespace relievo {

inline constexpr float kDrawRise = 0.5f;      // of the radius
inline constexpr float kUnitSpacing = 0.15f;  // of the radius
inline constexpr float kPinch = 0.15f;        // of the distance to the centre

// The weight at `part` of the radius, both in [0, 1], by falloff and hardness: 1 up to the hardness, 0 at the
// rim (but for constant and custom).
float falloff_weight(const Brush& brush, float part);

class Alpha;
class SavedHeights;
class Seams;
struct Hold;  // what grab holds (move_tools.cpp)

struct DabPlace {
    SurfacePoint centre;
    float pressure;               // [0, 1]
    float radius;                 // of this dab, world units
    glm::vec3 motion{0};          // from the last dab, world units; 0 at a stroke's first and after a jump
    glm::vec3 drag{0};            // of grab since the stroke began, world units
    float share;                  // of the strength, [0, 1]: copies by symmetry that overlap share it
    std::shared_ptr<Hold>& hold;  // of the stroke, null at first
    glm::vec3 hand{0};            // Dab::drag over kDragOne
    const Alpha* alpha = nullptr;          // of stamp; not null there
    const SurfacePoint* source = nullptr;  // of clone; not null there
    const SavedHeights* saved = nullptr;   // of erase to what was saved; not null there
};

// What a dab wants of one texel: changes since the stroke began, in counts, as StrokeTiles keeps them.
struct TexelChange {
    std::int32_t x, y;
    float from, to;
};

// Whether changes that overlapping copies want of a texel add up; else the largest counts.
bool adds_up(const Brush& brush);

// The changes of one dab, sorted by (y, x), each texel once. Reads `surface` (and by it the map as the last
// dab left it) and `stroke`; writes nothing but place.hold. `mask`: 65535 protects a texel; null: none.
std::vector<TexelChange> dab_changes(const Brush& brush, const DabPlace& place, const Surface& surface,
                                     const Seams& seams, const StrokeTiles& stroke, const HeightMap* mask);

}  // namespace relievo
