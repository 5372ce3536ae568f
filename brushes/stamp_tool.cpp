// The stamp: an image pressed into the surface, in a frame of world space, so that texture islands do not
// matter.
#include "brushes/dab_work.h"
#include "brushes/pressed_image.h"

namespace relievo {

void stamp(const Work& work) {
    const DabPlace& place = work.place;
    const std::vector<SurfaceTexel> texels = work.texels(place.radius);
    const PressedImage image(*place.alpha, place.centre, place.radius, place.hand, work.brush.rotation,
                             texels.size());
    const float counts = work.counts(double{kDrawRise} * double{place.radius}) * work.sign();
    for (const SurfaceTexel& texel : texels) {
        const float weight = work.weight(texel);
        if (weight == 0.0f) continue;
        if (const float value = image.at(texel); value != 0.0f) work.raise(texel, counts * weight * value);
    }
}

}  // namespace relievo
