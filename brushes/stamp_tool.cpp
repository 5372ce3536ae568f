// The stamp: an image pressed into the surface, in a frame of world space, so that texture islands do not
// matter.
#include <cmath>

#include "brushes/alpha.h"
#include "brushes/dab_work.h"
#include "brushes/tangent_frame.h"

namespace relievo {
namespace {

// Of the texels, from how many the ball holds, over its radius.
double texel_spacing(std::size_t texels) {
    return std::sqrt(3.14159265358979323846 / static_cast<double>(std::max(texels, std::size_t{1})));
}

}  // namespace

void stamp(const Work& work) {
    const SurfacePoint& centre = work.place.centre;
    const TangentFrame frame =
        turned(tangent_frame(centre.base_normal, work.place.hand), double{work.brush.rotation});
    const std::vector<SurfaceTexel> texels = work.texels(work.place.radius);
    const double footprint = texel_spacing(texels.size()), unit = 1.0 / double{work.place.radius};
    const float counts = work.counts(double{kDrawRise} * double{work.place.radius}) * work.sign();
    for (const SurfaceTexel& texel : texels) {
        const float weight = work.weight(texel);
        if (weight == 0.0f || !(glm::dot(texel.normal, centre.base_normal) > 0.0f)) continue;
        const glm::dvec3 offset = unit * (glm::dvec3(texel.position) - glm::dvec3(centre.position));
        const float value =
            work.place.alpha->at(glm::dot(offset, frame.right), glm::dot(offset, frame.up), footprint);
        if (value != 0.0f) work.raise(texel, counts * weight * value);
    }
}

}  // namespace relievo
