// What the reference asks of a height source: bounds over blocks of texel cells, and the cells' bilinear
// coefficients.
//
// In texel coordinates t, cell i spans [i, i + 1] between the centres of texels i and i + 1. Cell numbers are
// not wrapped: a triangle may reach over many periods of a map.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/scene/triangle_bounds.h"

namespace relievo::reference {

// Cells [low[a], high[a]) along the axes a = 0 (u) and 1 (v).
struct Cells {
    std::array<std::int64_t, 2> low, high;

    std::int64_t size(int axis) const {
        return high[static_cast<std::size_t>(axis)] - low[static_cast<std::size_t>(axis)];
    }
    bool single() const { return size(0) == 1 && size(1) == 1; }
};

// Counts in a cell: c00 + x cx + y cy + x y cxy, with (x, y) = t - corner.
struct CellCounts {
    double corner_x, corner_y, c00, cx, cy, cxy;
};

// From the counts of the cell's texels (0,0), (1,0), (0,1), (1,1).
inline CellCounts cell_counts(const Cells& single, double a, double b, double c, double d) {
    return {static_cast<double>(single.low[0]),
            static_cast<double>(single.low[1]),
            a,
            b - a,
            c - a,
            a - b - c + d};
}

class CellHeights {
  public:
    virtual ~CellHeights() = default;

    // The cells that hold the texel coordinates [low, high] of an axis; finite, below 2^50.
    virtual void cover(int axis, double low, double high, Cells& cells) const = 0;
    // Bounds of the heights over the cells, in counts. Equal ones mean that all heights are that count.
    virtual HeightRange range(const Cells& cells) const = 0;
    // Where to cut an axis of at least two cells.
    virtual std::int64_t cut(const Cells& cells, int axis) const = 0;
    virtual CellCounts counts(const Cells& single) const = 0;
};

}  // namespace relievo::reference
