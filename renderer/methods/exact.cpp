// Description of the method `exact`; its code is shaders/methods/exact/intersect.glsl.
#include "renderer/methods/all.h"

namespace relievo {
namespace {

constexpr MethodParameter kParameters[] = {
    {"correct_normals", "", "Shade with the interpolated normal in the base triangle's stead, so that a low-poly base "
                            "does not show.",
     0, 1, 1, true},
};

}  // namespace

const Method kExact{
    "exact",
    "Exact intersection",
    "Relievo; after quadtree displacement mapping (Drobot 2009) and Thonat and others 2021",
    "Triangles whose shell folds or leans far are searched by patches: right, but many times slower. What the ray touches "
    "within rounding may be met or passed.",
    GeometryKind::surface_bounds,
    HitPlace::on_surface,
    MapBounds::planes,
    kParameters,
    1048576,
};

}  // namespace relievo
