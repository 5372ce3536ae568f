// Finds where texel rows bend at an exact seam (brushes/seam_bends.h says what is done there).
//
// A column qualifies where the border runs midway between texel centres, both gutters are plain copies of the
// texels across, and the base mesh's two triangles put the texel rows at another angle or scale. A shift is a
// promise of equal heights, so what is found is checked: every column of every exact seam must still hold
// with the shifts, whatever the map, and no equation may read a shifted gutter; shifts that break this are
// dropped.
#pragma once

#include <vector>

#include "brushes/surface.h"
#include "editor/session/surface/seam_equations.h"
#include "editor/session/surface/uv_borders.h"

namespace relievo {

class TexelClasses;

struct BentSeams {
    std::vector<SeamBend> bends;
    std::vector<SeamCorner> corners;
};

// `classes` are the table's, complete; `sums` what no copies can make equal.
BentSeams find_bent_seams(const Mesh& mesh, const MapGrid& grid, const UvBorders& borders,
                          const TexelClasses& classes, const std::vector<TexelSum>& sums);

}  // namespace relievo
