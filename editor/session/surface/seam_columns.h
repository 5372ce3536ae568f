// Aligned seams texel by texel. Along such a seam the height between two texel columns is a mix of the
// columns' own heights where they cross the seam, so that both sides agree along all of it exactly when they
// agree on each column:
//   (1 - f) A0 + f A1 = (1 - f) B0 + f B1
// with A0 and A1 the texels below and above side a's edge, f its place between them, and B0, B1 the texels
// that the isometry lays on them. Columns reach half a texel past an edge's ends where its ends are not on
// texel centres.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "editor/session/surface/uv_borders.h"

namespace relievo {

struct SeamColumn {
    std::uint32_t a_in, a_out, b_in, b_out;  // b_in is a_out's place, b_out is a_in's
    double weight_in, weight_out;            // of a_in and b_out; of a_out and b_in; they add up to 1
    bool at_end;                             // within a texel of an end of the mesh edge
    bool past_end;                           // beyond it
};

void for_each_column(const UvSeam& seam, const MapGrid& grid,
                     const std::function<void(const SeamColumn&)>& visit);

}  // namespace relievo
