// How copies by symmetry that lie on one another share a dab's strength.
//
// Copies that move the same way do together what one does: each takes the share of the strength that is left
// when the overlap of the balls, along the line between their centres, is divided among them. Those that
// cross each other cover ground of their own before and behind: to share it there would leave a groove along
// the plane of a mirror.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "brushes/brush.h"

namespace relievo {

// The hand, or a copy, in world space.
struct MovingCopy {
    glm::dvec3 centre;
    glm::dvec3 motion;  // from the last dab; 0: none
};

// Whether the tool's copies share only where they move the same way. The others carry texels along or press
// whole images, which must not be done twice: theirs are to be given no motion.
bool shares_by_motion(Tool tool);

// One for each copy, in (0, 1]. `radius` of the dab, world units.
std::vector<float> copy_shares(std::span<const MovingCopy> all, double radius);

}  // namespace relievo
