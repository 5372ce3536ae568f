// Description of the method `march`; its code is shaders/methods/march/intersect.glsl.
#include "renderer/methods/all.h"

namespace relievo {
namespace {

constexpr double kSteps[] = {100, 300, 1000, 3000, 10000};

constexpr MethodParameter kParameters[] = {
    {"steps", "",
     "Steps across the object's bounding sphere: each is as long as its diameter over this. More are truer "
     "and "
     "slower; features thinner than a step can be missed.",
     10, 16384, 1000, false, kSteps},
    {"correct_normals", "",
     "Shade with the interpolated normal in the base triangle's stead, so that a low-poly base "
     "does not show.",
     0, 1, 1, true},
};

}  // namespace

const Method kMarch{
    "march",
    "Marching at a fixed step",
    "The baseline that procedural displacement (thesis 000, figure 6.3) is compared with",
    "Samples at a fixed step: misses what is thinner. Finds at best one sheet where the shell folds. At most "
    "16384 steps a "
    "prism.",
    GeometryKind::surface_bounds,
    HitPlace::in_prism,
    MapBounds::none,
    kParameters,
    16385,
};

}  // namespace relievo
