// Sharp creases mended by inserted triangles, so that parallel offset prisms stay finite.
//
// Paper 002 (projective displacement mapping), section 5.4: where two triangles meet at an interior angle
// under some threshold, the smooth normal N of the edge stands across both faces, N.Ng goes to 0 and the
// offset triangle of its equation 6 to infinity; inserting two triangles at the edge cures it. The paper does
// not say how. Ours is a bevel:
// - Both ends of the edge are doubled, one copy for each face, moved into that face at right angles to the
// edge by
//   kCreaseInset of the lower face's height. Two triangles close the strip between the copies; it looks out
//   of the crease.
// - All faces around an end follow one of the copies, so that the mesh stays closed. Where no other crease or
// border
//   leaves the end, the face that lies most between the two gets both copies and becomes a quad.
// - A copy's normal stands half way between its faces and the strip, so that N.Ng is about 0.7 on either.
// - Texture coordinates move with their corners; across a texture seam the strip belongs to the first face's
// island.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/scene/mesh.h"

namespace relievo {

constexpr double kCreaseInset = 1.0 / 32;
constexpr double kCreaseThresholdDeg = 5;

struct MendedMesh {
    Mesh mesh;  // positions of the input keep their index; bounds and sphere too
    std::vector<std::uint32_t>
        original_face;  // one a face: the input's face that it is a part of, or lies beside
    std::uint32_t mended_edges = 0;
};

// Mends edges of exactly two faces whose interior angle is less than the threshold (degrees, [0, 180)). Edges
// of one face or of more than two, faces without area, and ends at non-manifold edges stay as they are. A
// mesh without such creases comes back unchanged.
MendedMesh mend_creases(const Mesh& mesh, double threshold_deg = kCreaseThresholdDeg);

}  // namespace relievo
