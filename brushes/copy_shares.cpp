// See copy_shares.h.
#include "brushes/copy_shares.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace relievo {
namespace {

// 1 for copies that move the same way, or not at all; 0 for those that cross each other, or meet.
double agreement(const glm::dvec3& a, const glm::dvec3& b) {
    const double lengths = glm::length(a) * glm::length(b);
    return lengths > 0 ? std::clamp(glm::dot(a, b) / lengths, 0.0, 1.0) : 1.0;
}

}  // namespace

bool shares_by_motion(Tool tool) {
    constexpr ToolSet kByMotion = tool_set({Tool::draw, Tool::inflate, Tool::noise, Tool::crease});
    return holds(kByMotion, tool);
}

std::vector<float> copy_shares(std::span<const MovingCopy> all, double radius) {
    std::vector<float> parts;
    for (const MovingCopy& a : all) {
        double overlap = 0;
        for (const MovingCopy& b : all)
            overlap += std::max(0.0, 1.0 - glm::length(a.centre - b.centre) / (2.0 * radius)) *
                       agreement(a.motion, b.motion);
        parts.push_back(static_cast<float>(1.0 / std::max(overlap, 1.0)));
    }
    return parts;
}

}  // namespace relievo
