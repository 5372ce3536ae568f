// Surfaces that nobody would model, drawn at random: irregular low-poly meshes, slivers, soups; normals smooth, leaning or
// one a face; texture coordinates projected, in islands, mirrored, folded, squeezed to a line.
#pragma once

#include <string>

#include "renderer/stability/stability_case.h"

namespace relievo::stability {

struct IrregularCase {
    std::string what;  // in words, for messages
    Case surface;      // three views: two from outside and one from within, or of both sides
};

// `procedural`: heights by tiling and blending in a map's place.
IrregularCase irregular_case(unsigned seed, bool procedural);

}  // namespace relievo::stability
