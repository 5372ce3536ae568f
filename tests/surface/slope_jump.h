// How much the slope of the heights over the base mesh changes on the way over a mesh edge: what light along
// the surface shows.
#pragma once

#include <cstdint>
#include <vector>

#include "brushes/height_map.h"
#include "renderer/scene/mesh.h"
#include "renderer/scene/scene.h"

namespace relievo::test {

struct SlopeJump {
    std::uint32_t position[2];  // the mesh edge
    bool seam;                  // else an edge within an island
    bool aligned;               // of a seam
    double greatest;            // of its samples, eight a texel: world units of height a world unit across
    double mean;
};

// Of every edge of two triangles. Slopes are differences over half a texel either way, as the shading
// normal's.
std::vector<SlopeJump> slope_jumps(const Mesh& mesh, const HeightMap& map, const Displacement& displacement);

}  // namespace relievo::test
