// Description of the method `pdm`; its code is shaders/methods/pdm/intersect.glsl.
#include "renderer/methods/all.h"

namespace relievo {
namespace {

constexpr double kSteps[] = {0.02, 0.01, 0.005, 0.002, 0.001, 0.0005, 0.00025, 0.000125};

constexpr MethodParameter kParameters[] = {
    {"dt", "radii", "Step along the ray, as a fraction of the object's bounding-sphere radius. Smaller is truer and slower; "
                    "features thinner than a step can be missed.",
     1e-5, 0.1, 0.002, false, kSteps},
    {"jitter", "", "Shift the first sample at random (paper section 5.3), so that thin features appear over many samples "
                   "instead of never.",
     0, 1, 1, true},
    {"correct_normals", "", "Shade with the interpolated normal in the base triangle's stead (paper section 5.1), so that "
                            "a low-poly base does not show.",
     0, 1, 1, true},
};

}  // namespace

const Method kPdm{
    "pdm",
    "Projective displacement mapping",
    "Hoetzlein 2025, Projective Displacement Mapping for Ray Traced Editable Surfaces",
    "Samples at a fixed step: misses what is thinner. Projects along sum b_i N_i/(N_i.Ng), which differs between the "
    "two triangles of an edge on irregular meshes: gaps there, whatever the step. At most 16384 steps a prism.",
    GeometryKind::parallel_prisms,
    HitPlace::in_prism,
    MapBounds::none,
    kParameters,
    16385,
};

}  // namespace relievo
