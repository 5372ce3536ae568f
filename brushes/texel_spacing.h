// How far apart the texels of a dab's ball stand on the base mesh.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "brushes/surface.h"

namespace relievo {

// Between neighbours: from the mean of those in a row, and from the ball's area: relief takes texels out of
// the ball, and footprints may be stretched. Texels are added in the surface's order, each with its place on
// the base mesh.
class TexelSpacing {
  public:
    explicit TexelSpacing(double reach) : reach_(reach) {}  // of the ball

    void add(const SurfaceTexel& texel, glm::vec3 base) {
        if (texels_ > 0 && texel.x == x_ + 1 && texel.y == y_) {
            const double step = static_cast<double>(glm::length(base - base_));
            if (step <= reach_) sum_ += step, count_ += 1;  // else over a seam to another island
        }
        x_ = texel.x, y_ = texel.y, base_ = base;
        texels_ += 1;
    }

    std::size_t texels() const { return texels_; }
    // Of texels that lay evenly in the whole ball.
    double by_area() const { return reach_ * std::sqrt(3.14159265 / static_cast<double>(texels_)); }
    double value() const {
        return count_ > 0 && sum_ > 0 ? std::clamp(by_area(), sum_ / count_, 3.0 * sum_ / count_) : by_area();
    }

  private:
    double reach_, sum_ = 0, count_ = 0;
    std::size_t texels_ = 0;
    std::int32_t x_ = 0, y_ = 0;
    glm::vec3 base_{0};
};

}  // namespace relievo
