// The grid of sums and weights behind LowPass.
#include "brushes/low_pass.h"

#include <algorithm>
#include <cmath>

namespace relievo {

LowPass::LowPass(glm::vec3 centre, float reach, float cell)
    : low_(centre - glm::vec3(reach)),
      cell_(cell),
      side_(static_cast<int>(std::ceil(2.0f * reach / cell)) + 2) {
    const auto side = static_cast<std::size_t>(side_);
    cells_.resize(2 * side * side * side);
}

LowPass::Stencil LowPass::stencil(glm::vec3 position, bool back) const {
    std::size_t base[3];
    double part[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double at =
            std::clamp(double{position[axis] - low_[axis]} / double{cell_}, 0.0, double(side_ - 2));
        base[axis] = static_cast<std::size_t>(at);
        part[axis] = at - static_cast<double>(base[axis]);
    }
    const auto side = static_cast<std::size_t>(side_);
    Stencil result;
    for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t dx = i & 1, dy = i >> 1 & 1, dz = i >> 2;
        result.corner[i] = (((back ? side : 0) + base[2] + dz) * side + base[1] + dy) * side + base[0] + dx;
        result.weight[i] =
            (dx ? part[0] : 1.0 - part[0]) * (dy ? part[1] : 1.0 - part[1]) * (dz ? part[2] : 1.0 - part[2]);
    }
    return result;
}

void LowPass::add(glm::vec3 position, bool back, float value) {
    const Stencil at = stencil(position, back);
    for (std::size_t i = 0; i < 8; ++i) {
        cells_[at.corner[i]].sum += at.weight[i] * double{value};
        cells_[at.corner[i]].weight += at.weight[i];
    }
}

float LowPass::fetch(glm::vec3 position, bool back) const {
    const Stencil at = stencil(position, back);
    double sum = 0.0, weight = 0.0;
    for (std::size_t i = 0; i < 8; ++i) {
        sum += at.weight[i] * cells_[at.corner[i]].sum;
        weight += at.weight[i] * cells_[at.corner[i]].weight;
    }
    return static_cast<float>(sum / weight);
}

}  // namespace relievo
