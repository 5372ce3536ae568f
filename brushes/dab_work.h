// What the tools share: the dab at hand, its texels and their weights. Private to the tools.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "brushes/dab_tools.h"
#include "brushes/dab_trail.h"
#include "brushes/seams.h"
#include "brushes/shared_work.h"

namespace relievo {

struct Work {
    const Brush& brush;
    const DabPlace& place;
    const Surface& surface;
    const Seams& seams;
    const StrokeTiles& stroke;
    const HeightMap* mask;   // null: nothing is protected
    double counts_per_unit;  // of world height, signed; finite
    std::vector<TexelChange>& changes;

    float falloff(const SurfaceTexel& texel) const {
        const float part = std::min(texel.distance / place.radius, 1.0f);
        return falloff_weight(brush, part);
    }
    // 0 where the mask protects the texel.
    float free(const SurfaceTexel& t) const {
        return mask ? 1.0f - static_cast<float>(mask->at(t.x, t.y)) / kTop : 1.0f;
    }
    float weight(const SurfaceTexel& texel) const {
        return brush.strength * place.pressure * falloff(texel) * (place.share * free(texel));
    }
    // Steps towards a target are scaled so that a pass does the same at any spacing.
    float weight_of_step(const SurfaceTexel& texel) const {
        return std::min(weight(texel) * (brush.spacing / kUnitSpacing), 1.0f);
    }
    float change(const SurfaceTexel& t) const { return stroke.change(t.x, t.y); }
    float value(const SurfaceTexel& t) const { return stroke.value(t.x, t.y); }
    float sign() const { return brush.invert ? -1.0f : 1.0f; }

    std::vector<SurfaceTexel> texels(float radius) const {
        std::vector<SurfaceTexel> found;
        surface.texels_in_ball(place.centre.position, radius, found);
        return found;
    }
    // Faces away from the dab: on the far side of a thin object.
    bool is_back(const SurfaceTexel& t) const;

    // World units of height as counts. Bounded: a dab cannot need more than the whole range, and 0 * infinity
    // stays out for tiny amplitudes.
    float counts(double height) const {
        return static_cast<float>(
            std::clamp(height * counts_per_unit, -2.0 * double{kTop}, 2.0 * double{kTop}));
    }

    // Adds a rise in counts to the stroke's; without accumulate the larger of the two counts.
    void raise(const SurfaceTexel& t, float rise) const {
        const float so_far = change(t);
        if (brush.accumulate)
            change_to(t, so_far + rise);
        else if (std::abs(rise) > std::abs(so_far))
            change_to(t, rise);
    }

    void change_to(const SurfaceTexel& t, float to) const {
        const float from = change(t);
        if (to != from) changes.push_back({t.x, t.y, from, to});
    }
};

// Calls each(part, i) for every i in [0, count), in blocks that the cores share: `part` is `work` with
// changes of its own, which come together in the order of i, some blocks at a time: of a large dab, all of
// them would hold many megabytes twice.
template <typename Each>
void in_blocks(const Work& work, std::size_t count, const Each& each) {
    constexpr std::size_t kBlock = 2048;  // texels: of a tool that resamples, a few milliseconds
    constexpr std::size_t kAtATime = 64;  // blocks
    if (count <= kBlock) {
        for (std::size_t i = 0; i < count; ++i) each(work, i);
        return;
    }
    std::vector<std::vector<TexelChange>> changes(std::min((count + kBlock - 1) / kBlock, kAtATime));
    for (std::size_t begin = 0; begin < count; begin += kAtATime * kBlock) {
        const std::size_t end = std::min(count, begin + kAtATime * kBlock);
        share_work((end - begin + kBlock - 1) / kBlock, [&](std::size_t block) {
            const Work part{work.brush,  work.place, work.surface,         work.seams,
                            work.stroke, work.mask,  work.counts_per_unit, changes[block]};
            const std::size_t first = begin + block * kBlock;
            for (std::size_t i = first; i < std::min(end, first + kBlock); ++i) each(part, i);
        });
        for (auto& own : changes) {
            work.changes.insert(work.changes.end(), own.begin(), own.end());
            own.clear();
        }
    }
}

// The same for every texel of the dab's ball, each(part, texel), without a list of them all.
template <typename Each>
void in_ball(const Work& work, const Each& each) {
    const DabPlace& place = work.place;
    work.surface.visit_ball(place.centre.position, place.radius, [&](std::span<const SurfaceTexel> texels) {
        in_blocks(work, texels.size(), [&](const Work& part, std::size_t i) { each(part, texels[i]); });
    });
}

// The same for tools that keep the strongest of a stroke's dabs: every texel has its distance from the dab's trail.
template <typename Each>
void in_trail(const Work& work, const Each& each) {
    const DabPlace& place = work.place;
    const DabTrail trail(place.centre.position, place.motion, place.radius);
    if (trail.is_point()) return in_ball(work, each);
    work.surface.visit_ball(trail.middle(), trail.reach(place.radius), [&](std::span<const SurfaceTexel> texels) {
        in_blocks(work, texels.size(), [&](const Work& part, std::size_t i) {
            SurfaceTexel texel = texels[i];
            texel.distance = trail.distance(texel.position);
            if (texel.distance < place.radius) each(part, texel);
        });
    });
}

// What smooth looks at: the averages take in a margin around the brush, and where it covers only a few
// texels, their neighbourhood.
struct SmoothedBall {
    float reach;  // world units
    std::vector<SurfaceTexel> texels;
};
SmoothedBall smoothed_ball(const Surface& surface, glm::vec3 centre, float radius);
void smooth(const Work& work, const SmoothedBall& ball);

void draw(const Work& work);
void inflate(const Work& work);
void noise(const Work& work);
void clay(const Work& work);
void level(const Work& work);
void erase(const Work& work);
void paint_mask(const Work& work);
void smooth(const Work& work);
void flatten(const Work& work);
void pinch(const Work& work);
void crease(const Work& work);
void smear(const Work& work);
void grab(const Work& work);
void stamp(const Work& work);
void clone(const Work& work);

}  // namespace relievo
