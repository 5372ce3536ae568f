// See height_planes.h.
#include "renderer/height_planes.h"

#include <cmath>
#include <glm/glm.hpp>

namespace relievo {
namespace {

// Counts: bounds leave this much for what rounding does to heights, and as much for what it does to a plane that is told by
// its corners.
constexpr double kRounding = 0.01;
constexpr double kLeastTilt = 1e-6;  // of the places' moments: footprints narrower than that have no plane

HeightPlane bounds_about(const MapLinear& plane, const FootprintHeights& heights) {
    Span span;
    for (const HeightSample& s : heights.samples) {
        const double at = plane.at(s.x, s.y), across = plane.rise_x * s.wide, up = plane.rise_y * s.tall;
        span.include(s.low - at - std::max(across, 0.0) - std::max(up, 0.0));
        span.include(s.high - at - std::min(across, 0.0) - std::min(up, 0.0));
    }
    const double rounding = 2 * kRounding + 2 * FootprintHeights::kPlaces * plane.steepness();
    HeightPlane bounds;
    bounds.low = span.low - rounding;
    bounds.high = span.high + rounding;
    for (std::size_t i = 0; i < 3; ++i) bounds.corner[i] = plane.at(heights.corners[i].x, heights.corners[i].y);
    return bounds;
}

}  // namespace

std::optional<HeightPlane> height_plane(const FootprintHeights& heights) {
    double h = 0, xy = 0;
    glm::dvec2 sum(0), square(0), with(0);  // of places, and of places times heights
    for (const HeightSample& s : heights.samples) {
        const glm::dvec2 at(s.x + 0.5 * s.wide, s.y + 0.5 * s.tall);
        const double height = 0.5 * (s.low + s.high);
        sum += at;
        square += at * at;
        xy += at.x * at.y;
        h += height;
        with += at * height;
    }
    const auto n = static_cast<double>(heights.samples.size());
    const glm::dvec2 middle = sum / n, spread = square - sum * middle, slope = with - sum * (h / n);
    const double cross = xy - sum.x * middle.y, det = spread.x * spread.y - cross * cross;
    if (!(det > kLeastTilt * spread.x * spread.y)) return std::nullopt;
    MapLinear plane;
    plane.rise_x = (slope.x * spread.y - slope.y * cross) / det;
    plane.rise_y = (slope.y * spread.x - slope.x * cross) / det;
    plane.at0 = h / n - plane.rise_x * middle.x - plane.rise_y * middle.y;
    return bounds_about(plane, heights);
}

}  // namespace relievo
