// The texels that bilinear filtering can touch on a triangle, as convex pieces inside the map.
//
// In texel coordinates t = uv * size - 0.5 a point touches texel i when t lies in [i - 1, i + 1), so a
// triangle T touches the integer points of the Minkowski sum of T and the square [-1, 1]^2. That sum is the
// intersection of its bounding box with T's three edges' half planes, each moved out by |a| + |b|: cheap to
// test against a box of texels. The square is a little larger than 1, so that coordinates rounded to float on
// the device stay inside.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <span>

#include "renderer/scene/scene.h"

namespace relievo {

// Texels [x0, x1) x [y0, y1).
struct TexelBox {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

enum class Cover { none, some, all };

// The integer points of `box` with a[k] x + b[k] y + c[k] >= 0 for every k; `box` lies inside the map.
struct FootprintPiece {
    TexelBox box;
    double a[3] = {0, 0, 0}, b[3] = {0, 0, 0}, c[3] = {0, 0, 0};

    // How much of a box that is not empty belongs to the piece. `some` may also stand for none.
    Cover cover(const TexelBox& other) const;
    // The texels of row y, which lies in the box: [first, last), clipped to the box.
    void row(int y, int& first, int& last) const;
};

// The texels that a triangle touches before they are wrapped or clamped into the map, counted from (x, y).
struct UnwrappedFootprint {
    int x = 0, y = 0;
    FootprintPiece piece;               // its box begins at (0, 0) and holds one texel at least
    FootprintPiece inside;              // the texels of it whose centres lie in the triangle itself
    std::array<glm::dvec2, 3> corners;  // the triangle's, texels
};

constexpr std::size_t kMostFootprintPieces = 16;

// Fills `pieces` and returns their number, at least 1. A footprint over more map periods than there is room
// for is the whole map. Requires finite uvs and a size of at least 1 x 1.
std::size_t footprint_pieces(const std::array<glm::vec2, 3>& uvs, int width, int height, Wrap wrap,
                             std::span<FootprintPiece, kMostFootprintPieces> pieces);
// Nothing where texels that far out are not told apart. Requires finite uvs.
std::optional<UnwrappedFootprint> unwrapped_footprint(const std::array<glm::vec2, 3>& uvs, int width, int height);

}  // namespace relievo
