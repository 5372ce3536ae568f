// Settles columns of aligned seams by making texels equal: the part of the seam table that has to search.
#pragma once

#include <vector>

#include "editor/session/surface/seam_columns.h"
#include "editor/session/surface/texel_classes.h"

namespace relievo {

// Joins texels in `classes` until the columns hold; returns those that no equality of texels can satisfy.
// Owned texels are joined only where both islands' texels are the edge itself, or next to an edge's end.
std::vector<SeamColumn> settle(std::vector<SeamColumn> columns, const MapGrid& grid, TexelClasses& classes);

}  // namespace relievo
