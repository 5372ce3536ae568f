// Bounds of a displacement map's heights over one triangle, about a plane: where the map is smooth, a small triangle's
// heights leave a plane far less than they differ from each other, and what holds its part of the surface can be as thin as it
// (surface_hull.h).
#pragma once

#include <array>
#include <optional>

#include "renderer/footprint_heights.h"

namespace relievo {

// In counts, 0 to 65535: at barycentrics b a height is sum b_i corner_i + r with low <= r <= high.
struct HeightPlane {
    std::array<double, 3> corner{};
    double low = 0, high = 0;
    bool operator==(const HeightPlane&) const = default;
};

// About the plane that is nearest to the heights (least squares); nothing for a triangle that has no area in the map.
std::optional<HeightPlane> height_plane(const FootprintHeights& heights);

}  // namespace relievo
