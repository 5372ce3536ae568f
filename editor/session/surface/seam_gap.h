// How far apart the two sides of a seam are: the measure that tests and reports use.
#pragma once

#include <cstdint>
#include <vector>

#include "brushes/height_map.h"
#include "renderer/scene/mesh.h"
#include "renderer/scene/scene.h"

namespace relievo {

struct SeamGap {
    std::uint32_t position[2];  // the mesh edge
    bool aligned;   // both sides run along texel rows at one scale: expected to be 0 after a stroke
    double counts;  // largest difference of the bilinear heights along the edge, [0, 65535]
};

// Every seam, sampled at least eight times a texel, ends and cell borders included.
std::vector<SeamGap> seam_gaps(const Mesh& mesh, const HeightMap& map, Wrap wrap);

// The largest of them; 0 without seams.
double max_seam_gap(const Mesh& mesh, const HeightMap& map, Wrap wrap, bool aligned_only);

}  // namespace relievo
