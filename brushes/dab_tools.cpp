// The brush's falloff, and which tool a dab goes to.
#include "brushes/dab_tools.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "brushes/dab_work.h"

namespace relievo {

float falloff_weight(const Brush& brush, float part) {
    const float x = part <= brush.hardness ? 0.0f : (part - brush.hardness) / (1.0f - brush.hardness);
    switch (brush.falloff) {
        case Falloff::smooth:
            return (1.0f - x) * (1.0f - x) * (1.0f + 2.0f * x);
        case Falloff::linear:
            return 1.0f - x;
        case Falloff::sharp:
            return (1.0f - x) * (1.0f - x);
        case Falloff::constant:
            return 1.0f;
        case Falloff::custom:
            return brush.falloff_curve.weight(x);
    }
    return 0.0f;
}

bool Work::is_back(const SurfaceTexel& t) const {
    return glm::dot(t.normal, place.centre.normal) < 0.0f;
}

namespace {

void apply(const Work& work) {
    switch (work.brush.tool) {
        case Tool::draw:
            return draw(work);
        case Tool::smooth:
            return smooth(work);
        case Tool::flatten:
            return flatten(work);
        case Tool::level:
            return level(work);
        case Tool::erase:
            return erase(work);
        case Tool::inflate:
            return inflate(work);
        case Tool::clay:
            return clay(work);
        case Tool::crease:
            return crease(work);
        case Tool::pinch:
            return pinch(work);
        case Tool::grab:
            return grab(work);
        case Tool::smear:
            return smear(work);
        case Tool::noise:
            return noise(work);
        case Tool::stamp:
            return stamp(work);
        case Tool::clone:
            return clone(work);
        case Tool::mask:
            return paint_mask(work);
    }
}

}  // namespace

bool adds_up(const Brush& brush) {
    constexpr ToolSet kTowardsTarget = tool_set(
        {Tool::smooth, Tool::flatten, Tool::level, Tool::erase, Tool::clay, Tool::clone, Tool::mask});
    return brush.accumulate && !holds(kTowardsTarget, brush.tool);
}

std::vector<TexelChange> dab_changes(const Brush& brush, const DabPlace& place, const Surface& surface,
                                     const Seams& seams, const StrokeTiles& stroke, const HeightMap* mask) {
    std::vector<TexelChange> changes;
    const double counts_per_unit = double{kTop} / double{surface.amplitude()};
    if (brush.tool != Tool::mask && (!std::isfinite(counts_per_unit) || counts_per_unit == 0.0))
        return changes;
    apply({brush, place, surface, seams, stroke, mask, counts_per_unit, changes});
    return changes;
}

}  // namespace relievo
