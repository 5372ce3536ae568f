// The tools that raise, lower or move to a value: draw, inflate, noise, level, erase, mask.
#include <cmath>

#include "brushes/broad_slope.h"
#include "brushes/dab_work.h"
#include "brushes/noise.h"
#include "brushes/relief.h"
#include "brushes/saved_heights.h"

namespace relievo {
namespace {

// `part_of(texel)` scales what the brush raises there.
template <typename Part>
void raise(const Work& work, Part part_of) {
    const Brush& brush = work.brush;
    const double passes = brush.accumulate ? double{brush.spacing} : 1.0;
    const float counts = work.counts(double{kDrawRise} * double{work.place.radius} * passes) * work.sign();
    const auto raise_texel = [&](const Work& part, const SurfaceTexel& texel) {
        const float weight = part.weight(texel);
        if (weight != 0.0f) part.raise(texel, counts * weight * part_of(texel));
    };
    brush.accumulate ? in_ball(work, raise_texel) : in_trail(work, raise_texel);
}

// `target_of(texel)`, in counts, is where it moves a texel to.
template <typename Target>
void move_to(const Work& work, Target target_of) {
    in_trail(work, [&](const Work& part, const SurfaceTexel& texel) {
        const float before = static_cast<float>(part.stroke.before(texel.x, texel.y));
        const float change = (target_of(texel) - before) * part.weight(texel);
        if (std::abs(change) > std::abs(part.change(texel))) part.change_to(texel, change);
    });
}

}  // namespace

void draw(const Work& work) {
    raise(work, [](const SurfaceTexel&) { return 1.0f; });
}

void inflate(const Work& work) {
    constexpr double kLeastCosine = 0.25;
    const bool up = (work.counts_per_unit > 0.0) != work.brush.invert;
    const BroadSlope slopes(work, 1.1f * work.place.radius, up);
    raise(work, [&](const SurfaceTexel& texel) {
        const double slope = slopes.at(base_of(work, texel), texel.normal) / work.counts_per_unit;
        return static_cast<float>(std::min(std::sqrt(1.0 + slope * slope), 1.0 / kLeastCosine));
    });
}

void noise(const Work& work) {
    const double grain = double{work.brush.grain} * double{work.brush.radius};
    const auto seed = static_cast<std::uint32_t>(work.brush.seed);
    raise(work, [&](const SurfaceTexel& texel) {
        return static_cast<float>(gradient_noise(glm::dvec3(base_of(work, texel)) / grain, seed));
    });
}

void level(const Work& work) {
    move_to(work, [&](const SurfaceTexel&) { return work.brush.level * kTop; });
}

void erase(const Work& work) {
    const SavedHeights* saved = work.brush.erase_to == EraseTo::saved ? work.place.saved : nullptr;
    move_to(work, [&](const SurfaceTexel& texel) {
        return saved ? static_cast<float>(saved->at(texel.x, texel.y, work.stroke))
                     : work.surface.midlevel() * kTop;
    });
}

void paint_mask(const Work& work) {
    if (work.brush.blur) return smooth(work);
    move_to(work, [&](const SurfaceTexel&) { return work.brush.invert ? 0.0f : kTop; });
}

}  // namespace relievo
