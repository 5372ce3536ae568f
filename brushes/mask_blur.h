// Softening of a mask's borders. Private to the sculptor.
#pragma once

#include "brushes/height_map.h"

namespace relievo {

class Seams;
class Surface;

// Half of each texel that shows the surface, half the mean of those of its four neighbours that do. Gutters
// must hold their copies, and hold them no longer afterwards.
void blur_once(HeightMap& mask, const Surface& surface, const Seams& seams);

}  // namespace relievo
