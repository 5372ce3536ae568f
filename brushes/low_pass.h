// A low-pass filter over scattered samples in a ball: a coarse world-space grid into which values are
// splatted trilinearly and from which averages are fetched by quadratic B-splines, whose slope is continuous:
// trilinear ones bend at the grid's planes, which go along with the brush, so that a stroke of them would leave
// creases along its way. It knows nothing of texture space, so islands that meet in space are averaged across
// their seam, whatever their layout. Linear time, one fixed order of additions.
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
    // In cells from low_, within the grid that holds its neighbours, too.
    glm::dvec3 place(glm::vec3 position) const;
    std::size_t index(std::size_t x, std::size_t y, std::size_t z, bool back) const {
        return (((back ? side_ : 0) + z) * side_ + y) * side_ + x;
    }

    glm::vec3 low_;
    float cell_;
    std::size_t side_;
    std::vector<Cell> cells_;
};

}  // namespace relievo
