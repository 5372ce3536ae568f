// Heights of a map: a min-max pyramid over its texel cells.
//
// Texel coordinates are t = uv * size - 1/2. With clamp, everything left of texel 0 is cell -1 and everything right of
// the last texel is cell size - 1; an axis of one texel has the one cell 0.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/reference/cell_heights.h"
#include "renderer/reference/reference.h"

namespace relievo::reference {

class CellRanges final : public CellHeights {
  public:
    CellRanges(const ReferenceTexels<std::uint16_t>& map, Wrap wrap);

    void cover(int axis, double low, double high, Cells& cells) const override;
    HeightRange range(const Cells& cells) const override;
    // So that both parts fit the pyramid's nodes.
    std::int64_t cut(const Cells& cells, int axis) const override;
    CellCounts counts(const Cells& single) const override;

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
