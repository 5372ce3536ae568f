// Where a texture layout is cut: seams (one mesh edge, two places in the map) and open borders.
#pragma once

#include <cstdint>
#include <vector>

#include "editor/session/surface/texel_sampling.h"
#include "renderer/scene/mesh.h"

namespace relievo {

// One face's side of a mesh edge, in texel space.
struct UvSide {
    std::uint32_t face;
    glm::dvec2 from, to;  // both sides of a seam run from the same position of the mesh
    glm::dvec2 inner;     // the face's third corner: which side of the edge is the island's inside

    double length() const;  // texels
};

struct UvSeam {
    std::uint32_t position[2];  // the mesh edge
    UvSide a, b;
    // Both sides run along texel rows or columns, are equally long, and lie equally between texel centres, so
    // that the texels about one are those about the other, turned or mirrored: copies can make the heights
    // equal.
    bool aligned;
};

struct UvBorders {
    std::vector<UvSeam>
        seams;  // edges of exactly two faces that lie apart in the map (whole repeats do not count)
    std::vector<UvSide> open;  // edges of one face, or of three and more
};

// Edges are of mesh positions (identical positions are one, as load_mesh_file leaves them); in the order of
// positions.
UvBorders find_uv_borders(const Mesh& mesh, const MapGrid& grid);

// Whole-texel isometry that lays side a's surroundings on side b's, inside on outside. Requires an aligned
// seam.
struct TexelIsometry {
    std::int64_t xx, xy, yx, yy, tx, ty;

    std::int64_t x(std::int64_t i, std::int64_t j) const { return xx * i + xy * j + tx; }
    std::int64_t y(std::int64_t i, std::int64_t j) const { return yx * i + yy * j + ty; }
};
TexelIsometry across(const UvSeam& seam);

// Texture coordinates are floats: two texel coordinates this close are meant to be equal.
inline constexpr double kTexelSlack = 2e-3;

// The coordinate that was meant, where it is a multiple of 1/256 texel but for a float's rounding.
double snapped(double texel_coordinate);

}  // namespace relievo
