// The map at a place of the surface, as every method reads it: bilinear between texel centres.
#pragma once

#include <glm/vec2.hpp>

#include "brushes/height_map.h"
#include "renderer/scene/scene.h"

namespace relievo::gui {

double map_value(const HeightMap& map, Wrap wrap, const glm::dvec2& uv);  // counts, [0, 65535]

inline double displacement_of(const Displacement& d, double counts) {  // world units
    return d.amplitude * (counts / 65535 - d.midlevel);
}

}  // namespace relievo::gui
