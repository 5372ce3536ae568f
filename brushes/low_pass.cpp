// The grid of sums and weights behind LowPass.
#include "brushes/low_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace relievo {

// A cell more on each side: fetch() looks at three corners each way.
LowPass::LowPass(glm::vec3 centre, float reach, float cell)
    : low_(centre - glm::vec3(reach + cell)),
      cell_(cell),
      side_(static_cast<std::size_t>(std::ceil(2.0f * reach / cell)) + 4) {
    cells_.resize(2 * side_ * side_ * side_);
}

glm::dvec3 LowPass::place(glm::vec3 position) const {
    const glm::dvec3 at = glm::dvec3(position - low_) / double{cell_};
    return glm::clamp(at, glm::dvec3(1), glm::dvec3(static_cast<double>(side_) - 2.51));
}

void LowPass::add(glm::vec3 position, bool back, float value) {
    const glm::dvec3 at = place(position);
    const glm::dvec3 base = glm::floor(at), part = at - base;
    const auto x = static_cast<std::size_t>(base.x), y = static_cast<std::size_t>(base.y),
               z = static_cast<std::size_t>(base.z);
    for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t dx = i & 1, dy = i >> 1 & 1, dz = i >> 2;
        const double weight =
            (dx ? part.x : 1.0 - part.x) * (dy ? part.y : 1.0 - part.y) * (dz ? part.z : 1.0 - part.z);
        Cell& cell = cells_[index(x + dx, y + dy, z + dz, back)];
        cell.sum += weight * double{value};
        cell.weight += weight;
    }
}

float LowPass::fetch(glm::vec3 position, bool back) const {
    const glm::dvec3 at = place(position);
    const glm::dvec3 middle = glm::floor(at + 0.5), part = at - middle;  // [-0.5, 0.5]
    // Of the corner before, the nearest, and the one behind it.
    const glm::dvec3 weights[3] = {0.5 * (0.5 - part) * (0.5 - part), 0.75 - part * part,
                                   0.5 * (0.5 + part) * (0.5 + part)};
    const auto x = static_cast<std::size_t>(middle.x) - 1, y = static_cast<std::size_t>(middle.y) - 1,
               z = static_cast<std::size_t>(middle.z) - 1;
    double sum = 0.0, weight = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t j = 0; j < 3; ++j) {
            const Cell* const row = &cells_[index(x, y + j, z + k, back)];
            const double across = weights[j].y * weights[k].z;
            for (std::size_t i = 0; i < 3; ++i) {
                sum += across * weights[i].x * row[i].sum;
                weight += across * weights[i].x * row[i].weight;
            }
        }
    return static_cast<float>(sum / weight);
}

}  // namespace relievo
