// The map at a place of the surface.
#include "editor/gui/map_value.h"

#include <algorithm>
#include <cmath>

namespace relievo::gui {

double map_value(const HeightMap& map, Wrap wrap, const glm::dvec2& uv) {
    const auto wrapped = [&](double t, int size) {
        const double s = size;
        const double inside = wrap == Wrap::repeat ? t - s * std::floor(t / s) : std::clamp(t, 0.0, s - 1);
        return std::clamp(static_cast<int>(inside), 0, size - 1);
    };
    const auto texel = [&](double x, double y) {
        return static_cast<double>(map.at(wrapped(x, map.width()), wrapped(y, map.height())));
    };
    const double x = uv.x * map.width() - 0.5, y = uv.y * map.height() - 0.5;
    const double x0 = std::floor(x), y0 = std::floor(y), fx = x - x0, fy = y - y0;
    return (texel(x0, y0) * (1 - fx) + texel(x0 + 1, y0) * fx) * (1 - fy) +
           (texel(x0, y0 + 1) * (1 - fx) + texel(x0 + 1, y0 + 1) * fx) * fy;
}

}  // namespace relievo::gui
