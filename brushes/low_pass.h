// A low-pass filter over scattered samples in a ball: a coarse world-space grid into which values are
// splatted trilinearly and from which averages are fetched trilinearly. It knows nothing of texture space, so
// islands that meet in space are averaged across their seam, whatever their layout. Linear time, one fixed
// order of additions.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace relievo {

class LowPass {
  public:
    // Holds samples within `reach` of `centre`; features smaller than `cell` vanish. Requires 0 < cell, 0 <
    // reach, reach / cell at most a few dozen.
    LowPass(glm::vec3 centre, float reach, float cell);

    // `back`: on the far side of a thin object; the two sides do not mix.
    void add(glm::vec3 position, bool back, float value);
    // The average around a position where something was added.
    float fetch(glm::vec3 position, bool back) const;

  private:
    struct Cell {
        double sum = 0.0, weight = 0.0;
    };
    struct Stencil {
        std::size_t corner[8];
        double weight[8];
    };
    Stencil stencil(glm::vec3 position, bool back) const;

    glm::vec3 low_;
    float cell_;
    int side_;
    std::vector<Cell> cells_;
};

}  // namespace relievo
