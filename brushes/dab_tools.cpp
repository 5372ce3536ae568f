// The brush's falloff, and which tool a dab goes to.
#include "brushes/dab_tools.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

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

namespace {

// The changes that copies want of one row, in the copies' order: each texel gets what they want together.
void apply_row(std::vector<TexelChange>& row, bool add_up, StrokeTiles& stroke) {
    const auto by_column = [](const TexelChange& a, const TexelChange& b) { return a.x < b.x; };
    if (!std::is_sorted(row.begin(), row.end(), by_column))
        std::stable_sort(row.begin(), row.end(), by_column);
    for (std::size_t i = 0; i < row.size();) {
        const TexelChange first = row[i];
        double sum = 0;
        float largest = 0;
        std::size_t count = 0;
        for (; i < row.size() && row[i].x == first.x; ++i, ++count) {
            const float step = row[i].to - row[i].from;
            sum += double{step};
            if (std::abs(step) > std::abs(largest) || (step == -largest && step > 0)) largest = step;
        }
        const float together = first.from + (add_up ? static_cast<float>(sum) : largest);
        stroke.set_change(first.x, first.y, count == 1 ? first.to : together);
    }
}

}  // namespace

void apply_together(std::span<const std::vector<TexelChange>> of_copies, bool add_up, StrokeTiles& stroke) {
    std::vector<std::size_t> next(of_copies.size(), 0);
    std::vector<TexelChange> row;
    while (true) {
        std::int32_t y = std::numeric_limits<std::int32_t>::max();
        for (std::size_t k = 0; k < next.size(); ++k)
            if (next[k] < of_copies[k].size()) y = std::min(y, of_copies[k][next[k]].y);
        row.clear();
        for (std::size_t k = 0; k < next.size(); ++k)
            for (; next[k] < of_copies[k].size() && of_copies[k][next[k]].y == y; ++next[k])
                row.push_back(of_copies[k][next[k]]);
        if (row.empty()) return;
        apply_row(row, add_up, stroke);
    }
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
