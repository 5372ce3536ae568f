// See close_bounds.h.
#include "renderer/close_bounds.h"

#include <algorithm>
#include <cmath>

namespace relievo {
namespace {

// A plane is of use where it brings the heights' spread below this part of it.
constexpr double kNarrowPlane = 0.9;

DisplacementPlane displacement_plane(const HeightPlane& plane, const MapSurface& surface) {
    const double count = surface.amplitude / 65535;
    DisplacementPlane d;
    for (std::size_t i = 0; i < 3; ++i) d.corner[i] = plane.corner[i] * count - surface.amplitude * surface.midlevel;
    d.low = std::min(plane.low * count, plane.high * count);
    d.high = std::max(plane.low * count, plane.high * count);
    return d;
}

}  // namespace

CloseBounds close_bounds(const MappedTriangle& triangle, const MapSurface& surface) {
    const auto heights = footprint_heights(surface.map, surface.pyramid, triangle.uvs);
    if (!heights) return {};
    CloseBounds bounds{height_plane(*heights), map_surface_box(triangle.primitive, triangle.normals, *heights,
                                                               surface.amplitude, surface.midlevel)};
    if (bounds.plane) {
        const double spread = std::abs(surface.amplitude) / 65535 * (bounds.plane->high - bounds.plane->low);
        if (!(spread < kNarrowPlane * (triangle.range.high - triangle.range.low))) bounds.plane.reset();
    }
    return bounds;
}

Box box_within(const CloseBounds& bounds, const MappedTriangle& triangle) {
    const Box box = surface_box(triangle.primitive, triangle.normals, triangle.range);
    return bounds.box ? overlap(box, *bounds.box) : box;
}

SurfaceHull hull_within(const CloseBounds& bounds, const MappedTriangle& triangle, const MapSurface& surface) {
    return bounds.plane ? surface_hull(triangle.primitive, triangle.normals, displacement_plane(*bounds.plane, surface))
                        : surface_hull(triangle.primitive, triangle.normals, triangle.range);
}

}  // namespace relievo
