// What bounds a triangle's part of S under a displacement map as closely as the map tells: a plane beside which its heights
// stay (for slabs, surface_hull.h), and the box of the surface itself. For methods whose hits lie on S.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <optional>

#include "renderer/height_planes.h"
#include "renderer/surface_box.h"
#include "renderer/surface_hull.h"

namespace relievo {

struct CloseBounds {
    std::optional<HeightPlane> plane;  // where heights leave it clearly less than they differ
    std::optional<Box> box;
    bool operator==(const CloseBounds&) const = default;
};

struct MapSurface {
    const HeightView& map;
    const HeightPyramid& pyramid;  // of the map
    double amplitude, midlevel;
};

// One triangle of a mapped surface.
struct MappedTriangle {
    const gpu::Primitive& primitive;
    gpu::PrimitiveNormals normals;
    std::array<glm::vec2, 3> uvs;
    const DisplacementRange& range;
};

CloseBounds close_bounds(const MappedTriangle& triangle, const MapSurface& surface);

Box box_within(const CloseBounds& bounds, const MappedTriangle& triangle);
SurfaceHull hull_within(const CloseBounds& bounds, const MappedTriangle& triangle, const MapSurface& surface);

}  // namespace relievo
