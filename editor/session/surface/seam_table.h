// Builds the seam table of a texture layout: which texels must be copies of which, and equations for the
// rest.
//
// Along an aligned seam (uv_borders.h) each gutter texel is a copy of the texel that the isometry lays on it,
// with a shift where texel rows bend there (bent_seams.h).
// Past the seam's end stands a corner texel that copies along the edges leave open: it is settled so that the
// last half texel agrees too. Where three islands meet, their three corner texels become one value; where
// four meet, each takes the island's across; where a seam ends in a corner cut out of one island, exactness
// needs two owned texels to be equal, and one becomes a copy of the other, as on seams that run along texel
// centres. What no copies can make equal (slanted or scaled seams, five islands at a vertex, islands so close
// that a gutter serves two) goes into equations, as in seam erasure (Liu, Ferguson, Jacobson and Gingold,
// "Seamless: Seam erasure and seam-aware decoupling of shape from mesh resolution", ACM TOG 36(6), 2017), but
// with all samples' texels, and none of them a copy. Texels past an open border that filtering reads are
// copies of the nearest texel of their face.
#pragma once

#include "brushes/surface.h"
#include "editor/session/surface/texel_sampling.h"
#include "renderer/scene/mesh.h"

namespace relievo {

class OwnedTexels;

SeamTable build_seam_table(const Mesh& mesh, const MapGrid& grid, const OwnedTexels& owned);
SeamTable build_seam_table(const Mesh& mesh, int width, int height, Wrap wrap);

}  // namespace relievo
