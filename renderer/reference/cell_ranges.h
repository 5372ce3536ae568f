// Least and greatest heights over blocks of texel cells, and the cells' bilinear coefficients.
//
// In texel coordinates t = uv * size - 1/2, cell i spans [i, i + 1] between the centres of texels i and i
// + 1. Cell numbers are not wrapped: a triangle may reach over many periods of the map. With clamp,
// everything left of texel 0 is cell -1 and everything right of the last texel is cell size - 1; an axis of
// one texel has the one cell 0.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/reference/reference.h"
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

class CellRanges {
  public:
    CellRanges() = default;
    CellRanges(const ReferenceTexels<std::uint16_t>& map, Wrap wrap);

    // The cells that hold the texel coordinates [low, high] of an axis; finite, below 2^50.
    void cover(int axis, double low, double high, Cells& cells) const;
    // Bounds of the heights over the cells, in counts.
    HeightRange range(const Cells& cells) const;
    // Where to cut an axis of at least two cells so that both parts fit the pyramid's nodes.
    std::int64_t cut(const Cells& cells, int axis) const;
    CellCounts counts(const Cells& single) const;

  private:
    // One axis: how cell numbers go to texels and to columns (or rows) of the pyramid.
    struct Axis {
        std::int64_t texels = 0, cells = 0;
        bool repeat = true;

        std::int64_t local(std::int64_t cell) const;  // column of the pyramid, [0, cells)
        std::int64_t texel(std::int64_t cell) const;  // left texel; `cell` + 1 gives the right one
        void span(std::int64_t low, std::int64_t high, std::int64_t& first, std::int64_t& last) const;
    };
    struct Level {
        std::int64_t width, height;
        std::vector<HeightRange> nodes;
    };
    // Nodes of levels_[k] cover 2^(k + kFirstLevel) cells a side; smaller blocks are read from the texels.
    static constexpr int kFirstLevel = 2;

    std::uint16_t at(std::int64_t x, std::int64_t y) const { return texels_[y * axes_[0].texels + x]; }
    HeightRange scan(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) const;
    void build();

    std::array<Axis, 2> axes_;
    const std::uint16_t* texels_ = nullptr;
    std::vector<Level> levels_;
};

}  // namespace relievo::reference
