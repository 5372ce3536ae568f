// How much work a dab is, and how much memory, before it is made.
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

// What the copies of a dab may hold together while they are worked out, in bytes: so many of them are in work
// at a time, whatever the cores, though always one. What grab holds from dab to dab is not among it.
inline constexpr std::size_t kDabBytes = std::size_t{96} << 20;

// Bytes that one copy with so many texels in its ball takes in work, from above: measured, tested. With grab,
// what it holds for the rest of the stroke included.
std::size_t bytes_of_copy(Tool tool, std::size_t texels);

// From 1 up.
std::size_t copies_at_once(Tool tool, std::size_t texels);

}  // namespace relievo
