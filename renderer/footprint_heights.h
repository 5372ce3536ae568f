// A map's heights over one triangle as a list of samples, such that what is linear in place and height, or nearly, is least and
// greatest at one of them: for bounds of what is made of heights (height_planes.h, surface_box.h). The list is short whatever
// the map's size: of small triangles exact, of larger ones whole texels that they touch, of large ones nodes of the min-max
// pyramid.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "renderer/height_pyramid.h"
#include "renderer/scene/texel_footprint.h"

namespace relievo {

// Heights from low to high, in counts, at places from (x, y) to (x + wide, y + tall), in texels from the footprint's origin.
struct HeightSample {
    double x, y, wide, tall, low, high;
};

struct FootprintHeights {
    // Texels by which a place in the map may be rounded, or lie beside its triangle.
    static constexpr double kPlaces = 1.0 / 1024;

    std::array<glm::dvec2, 3> corners;  // the triangle's, texels from the footprint's origin
    std::vector<HeightSample> samples;
};

// Nothing for a triangle that lies too far out for its texels to be told, or is that much larger than its map. `pyramid` is
// that of `map`.
std::optional<FootprintHeights> footprint_heights(const HeightView& map, const HeightPyramid& pyramid,
                                                  const std::array<glm::vec2, 3>& uvs);

// A function that is linear over the map.
struct MapLinear {
    double at0 = 0, rise_x = 0, rise_y = 0;
    double at(double x, double y) const { return at0 + rise_x * x + rise_y * y; }
    double steepness() const { return std::abs(rise_x) + std::abs(rise_y); }
};
// The one with these values at the triangle's corners; not finite where it has no area in the map.
MapLinear linear_through(const std::array<double, 3>& values, const std::array<glm::dvec2, 3>& corners);

// The least and the greatest of numbers.
struct Span {
    double low = 1e300, high = -1e300;
    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

}  // namespace relievo
