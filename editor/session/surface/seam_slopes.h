// How the texel rows of the two triangles of an exact seam lie to each other in space.
#pragma once

#include <array>

#include "brushes/surface.h"
#include "editor/session/surface/uv_borders.h"

namespace relievo {

// The weights of a column whose two neighbours are both there; all 0 where rows go straight on at one scale,
// and where a triangle has no area to speak of. Requires an aligned seam.
struct SlopeWeights {
    std::int32_t lean, bend[2];  // SeamBend::kOne is 1; along ascending columns of side a
};
SlopeWeights slope_weights(const Mesh& mesh, const MapGrid& grid, const UvSeam& seam);

// Weights of three islands' corner texels for the height at the vertex where they meet, not negative: those
// with which a plane over the vertex's tangent plane has its own height there. seams[k] is the one that does
// not touch island k; all three must share a position, else (and where the spokes lie on one side) all are
// equal.
std::array<std::int32_t, 3> vertex_weights(const Mesh& mesh, const std::array<const UvSeam*, 3>& seams);

}  // namespace relievo
