// Seams that copies cannot make exact, as linear equations on texels, and where an edge crosses bilinear
// cells.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "brushes/surface.h"
#include "editor/session/surface/seam_columns.h"
#include "editor/session/surface/uv_borders.h"

namespace relievo {

class TexelClasses;

// sum of weight * texel = 0; the positive weights add up to 1.
using TexelSum = std::vector<std::pair<std::uint32_t, double>>;

// Parameters of [0, 1] at which a side passes from one bilinear cell to the next, ascending, 0 and 1
// included.
std::vector<double> cell_crossings(const UvSide& side);

// Samples of "height on side a = height on side b": the ends and the middle of every stretch on which neither
// side changes its bilinear cell, cut to at most half a texel of the side with more texels. So every texel
// that the filter reads along the seam is in some equation, and the difference, a quadratic on a stretch, is
// nowhere much larger than in them.
void add_seam_samples(const UvSeam& seam, const MapGrid& grid, std::vector<TexelSum>& sums);

TexelSum column_sum(const SeamColumn& column);

// The sum over class roots: equal texels merged, zero weights dropped, sorted by texel.
TexelSum reduced(const TexelSum& sum, const TexelClasses& classes);

// Reduced sums as equations of the brushes, without those that always hold, each once.
std::vector<SeamEquation> equations(const std::vector<TexelSum>& sums, const TexelClasses& classes);

}  // namespace relievo
