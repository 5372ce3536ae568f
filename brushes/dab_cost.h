// How much work a dab is, before it is made.
#pragma once

#include <cstddef>

#include "brushes/brush.h"
#include "brushes/surface.h"

namespace relievo {

struct DabCost {
    std::size_t texels;  // within the brush's ball
    std::size_t copies;  // by symmetry, the hand among them
    double work;         // texels that draw would visit in the time, all copies together
};

// Of a dab of full size at `centre`. Throws as symmetry_copies().
DabCost dab_cost(const Brush& brush, const SurfacePoint& centre, const Surface& surface);

}  // namespace relievo
