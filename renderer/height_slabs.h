// Bounds of a displacement map's heights about planes, from which a ray's height is told more closely than from the least
// and the greatest height: where a map is smooth, heights leave a plane by the square of a node's width, not by the width.
//
// Nodes and levels are those of the min-max pyramid (height_pyramid.h), overlap included. The plane goes by the heights at
// the node's corners; it is level where that brings less than a quarter of the range, and along the borders under clamp,
// where heights go on without end.
#pragma once

#include <cstdint>

#include "renderer/height_pyramid.h"

namespace relievo {

// As texels of four 16-bit integers. Heights are in counts, 0 to 65535. At texel (u, v) the plane lies
// ((u - m) rise_x + (v - n) rise_y) / 2^level high, with (m, n) the node's middle, texel ((i + 1) 2^level, (j + 1) 2^level).
struct PackedSlab {
    std::int16_t low, high;       // least and greatest height over the plane, less 32768
    std::int16_t rise_x, rise_y;  // of the plane over 2^level texels
};

// Finest levels that are not kept of a large map: they hold most of the memory, and reading so much of it costs rays more
// than two cells in place of one (measured from 4096 x 4096 on; 2 to 6% the other way at 2048).
constexpr int slab_levels_left_out(int width, int height) {
    return static_cast<std::int64_t>(width) * height >= (1 << 24) ? 1 : 0;
}

// Of the overlapping node (i, j) of a level of `pyramid`, which is that of `map`.
PackedSlab height_slab(const HeightView& map, const HeightPyramid& pyramid, int level, int i, int j);

}  // namespace relievo
