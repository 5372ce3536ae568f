// Description of the method `tessellated`; its code is renderer/micro_mesh.cpp (the micro-triangles) and
// shaders/methods/tessellated/intersect.glsl.
#include "renderer/methods/all.h"

namespace relievo {
namespace {

constexpr double kDensities[] = {0.25, 0.5, 1};

constexpr MethodParameter kParameters[] = {
    {.name = "density",
     .unit = "rows a texel",
     .tooltip = "Rows of micro-triangles a texel of the map; more are truer and take more memory, and "
                "everything is built "
                "anew when it changes.",
     .low = 0.01,
     .high = 4,
     .standard = 0.25,
     .sweep = kDensities,
     .shapes_build = true},
    {"correct_normals", "",
     "Shade with the interpolated normal in the base triangle's stead, so that a low-poly base "
     "does not show.",
     0, 1, 1, true},
};

}  // namespace

const Method kTessellated{
    "tessellated",
    "Tessellated in advance",
    "The baseline of Hoetzlein 2025 and of the thesis; watertight test of Woop, Benthin and Wald 2013",
    "At most 4,194,304 micro-triangles, about 60 bytes each in our own tree, 130 in lavapipe's; all "
    "of them are built again when density, mesh or source change. An edit moves the touched ones and refits the "
    "tree.",
    GeometryKind::triangles,
    HitPlace::in_box,
    MapBounds::none,
    kParameters,
    1,
};

}  // namespace relievo
