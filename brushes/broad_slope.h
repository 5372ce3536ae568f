// The slope of the relief at the scale of a brush: what inflate scales its rise by.
//
// Slopes from texel to texel are no measure for it: at texture seams two texels may stand almost at one
// place, and a count between them is a cliff. So texels are gathered in cells of several texels in world
// space on the base mesh, each cell corner with the moments of those around by trilinear weights, and the
// gradient there is that of a plane through them by least squares: exact for linear relief, blind to what is
// narrower than a cell, and the same across islands that meet in space, whatever their layout. Between
// corners the slope is interpolated.
//
// Dab after dab, a rise by the slope follows h_t = sqrt(1 + |grad h|^2), which differences taken about a
// place make unstable: waves and spikes would grow behind every edge. After S. Osher, J. A. Sethian, "Fronts
// propagating with curvature-dependent speed", J. Comput. Phys. 79, 1988, gradients are taken upwind: where
// the relief rises, half a cell uphill, so that tops stay even and the feet of slopes move outwards. At the
// usual spacing a dab raises by less than a third of a cell; stability asks for less than one.
//
// Sides that face apart must not mix, as those of a thin object: every corner has moments for each of the six
// directions along the axes, and a texel adds to the three that its normal leans to by the squares of its
// components, after the ambient cube in J. McTaggart, "Half-Life 2 / Valve Source Shading", GDC 2004.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "brushes/surface.h"

namespace relievo {

struct Work;

class BroadSlope {
  public:
    // Of the texels within `reach` of the dab's centre, with the stroke's values; of more where those are
    // few. `up`: the values are to rise, else to fall.
    BroadSlope(const Work& work, float reach, bool up);

    // Counts per world unit along the base, the steepest way, where one of these texels stands on the base
    // mesh. Relief counts as even along texels so long that none has a neighbour within a cell, and many
    // radii away from the dab's centre on the base mesh.
    double at(glm::vec3 base, glm::vec3 normal) const;

  private:
    // Of a cell, for one side. Sums are weighted; places are in cells from the dab's centre, values in
    // counts.
    struct Corner {
        glm::dvec3 at;
        int side;
        double weight = 0, value = 0;
        glm::dvec3 normal{0}, place{0}, place_value{0};
        glm::dmat3 place_place{0};
        glm::dvec3 gradient{0};  // counts a cell
        double slope = 0;        // upwind
    };

    void add(glm::vec3 base, glm::vec3 normal, double value);
    void fit_plane(Corner& corner) const;
    glm::dvec3 gradient(glm::dvec3 place, int side) const;
    double upwind_slope(const Corner& corner, bool up) const;

    glm::dvec3 centre_;
    double cell_ = 1;                       // world units on the base mesh
    std::vector<std::uint32_t> corner_at_;  // by place and side, into corners_
    std::vector<Corner> corners_;
};

}  // namespace relievo
