// Prisms whose ends lie along their own part of the surface. A small triangle of a smooth map is a thin tile that lies
// aslant: between ends parallel to the base triangle the prism is several times as high as the tile, and a ray is walked
// through what is empty. The planes are those between which the triangle's hull lies (surface_hull.h), as tight as one
// direction of k-DOPs (Klosowski and others 1998).
#pragma once

#include "renderer/close_bounds.h"
#include "renderer/primitives.h"
#include "renderer/surface_hull.h"

namespace relievo {

// The triangle's primitive with slanted ends (gpu::kPrimitiveSlanted), where that makes the prism much lower, else as it is.
// Its hull holds S; the primitive has its shell (set_shell).
gpu::Primitive with_slant(const MappedTriangle& triangle, const SurfaceHull& hull);
inline bool is_slanted(const gpu::Primitive& primitive) { return (primitive.flags & gpu::kPrimitiveSlanted) != 0; }

}  // namespace relievo
