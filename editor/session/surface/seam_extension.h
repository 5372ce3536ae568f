// What texels outside an island should hold beside a slanted or scaled seam, where no copy can be exact: the
// other island's heights where the island's texel-to-world map, carried on over the seam, puts them. So
// slopes pass the seam, and what the equations have left to do is little.
//
// The place is found in the planes of the seam's two triangles, unfolded at their edge. The height there is
// that of a plane through the owned texels about it, least squares with the near ones counting most, which
// extends past the other island's border by as much as a texel.
#pragma once

#include <vector>

#include "brushes/surface.h"
#include "editor/session/surface/uv_borders.h"

namespace relievo {

class TexelClasses;

// Of every texel within two texels of a seam that is not aligned, that no triangle owns and that is no copy;
// by its nearest seam. Sorted by texel.
std::vector<SeamExtension> extend_over_seams(const Mesh& mesh, const MapGrid& grid, const UvBorders& borders,
                                             const TexelClasses& classes);

}  // namespace relievo
