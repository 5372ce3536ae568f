// The box of S over one triangle of a displacement map, as narrow as the surface: of what it is made of, not of the least and
// the greatest height over the whole triangle. Every ray that a box does not stop costs a prism, and small triangles under a
// map that is aslant there had boxes half as large again as need be.
#pragma once

#include <optional>

#include "renderer/footprint_heights.h"
#include "renderer/primitives.h"

namespace relievo {

// A little larger than rounding needs. `heights`: over the triangle. Nothing where it has no area in the map.
std::optional<Box> map_surface_box(const gpu::Primitive& primitive, const gpu::PrimitiveNormals& normals,
                                   const FootprintHeights& heights, double amplitude, double midlevel);

}  // namespace relievo
