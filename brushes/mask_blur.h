// Softening of a mask's borders. Private to the sculptor.
#pragma once

#include "brushes/advance.h"
#include "brushes/height_map.h"

namespace relievo {

class Seams;
class Surface;

// Half of each texel that shows the surface, half the mean of those of its four neighbours that do. Gutters
// must hold their copies, and hold them no longer afterwards. Stopped, it leaves the mask changed in part.
void blur_once(HeightMap& mask, const Surface& surface, const Seams& seams, const Advance& advance);

}  // namespace relievo
