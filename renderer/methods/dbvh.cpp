// Description of the method `dbvh`; its code is shaders/methods/dbvh/intersect.glsl.
#include "renderer/methods/all.h"

namespace relievo {
namespace {

constexpr double kLeaves[] = {0, 1, 2};
constexpr std::string_view kLeafNames[] = {"box", "triangles", "bilinear", "bspline"};
constexpr double kLatticeLeaves[] = {0, 2};
constexpr double kRanges[] = {8, 16, 64, 128, 256, 512, 0};  // thesis 000, table 6.1; last, the texels
constexpr double kLevels[] = {3, 2, 1, 0};

constexpr MethodParameter kParameters[] = {
    {"leaf", "",
     "What is met where the level of detail is reached: the box itself, two triangles a square, the bilinear "
     "surface, or a smooth B-spline, which rounds the map's peaks.",
     0, 3, 2, false, kLeaves, kLatticeLeaves, kLeafNames},
    {"level", "",
     "Level of detail: a leaf is 2^level texels wide; on a map that repeats, no wider than divides both its sides. "
     "0 is the map itself.",
     0, 10, 0, false, kLevels},
    {"by_pixel", "",
     "Squares whose box looks smaller than a pixel are met as boxes: quicker far away, true to a pixel.", 0,
     1, 0, true},
    {"correct_normals", "",
     "Shade with the interpolated normal in the base triangle's stead, so that a low-poly base "
     "does not show.",
     0, 1, 1, true},
    {"range", "",
     "Procedural heights: parts a side that a lattice triangle is divided into, a power of two from 8 to "
     "512. 0: the source's own texels, true to the surface; they stand in, too, where parts would be far "
     "smaller than a texel, or a triangle is too thin to be divided.",
     0, 512, 0, false, {}, kRanges},
};

}  // namespace

const Method kDbvh{
    "dbvh",
    "Displacement BVH",
    "Thonat and others 2021, Tessellation-Free Displacement Mapping for Ray Tracing",
    "Boxes are met whole and B-splines smooth the map, so both differ from the surface by up to a texel's "
    "heights. "
    "B-splines, and leaves above level 0, may reach beyond a base triangle's box, which cuts them. A ray that "
    "met nothing in 122880 boxes of a wide triangle ends at the next box.",
    GeometryKind::surface_bounds,
    HitPlace::in_box,
    MapBounds::heights,
    kParameters,
    131072,
};

}  // namespace relievo
