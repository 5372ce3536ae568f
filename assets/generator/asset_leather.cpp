// A leather ball: eight sewn panels of pebbled hide.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "assets/generator/builders.h"
#include "assets/generator/noise.h"
#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

// Pebbles between creases, of two sizes, warped so that no lattice shows.
double grain(glm::dvec3 d) {
    const glm::dvec3 warp{noise(d * 6.0, 1), noise(d * 6.0, 2), noise(d * 6.0, 3)};
    const glm::dvec3 p = d + 0.035 * warp;
    const Cells coarse = cellular_noise(p * 21.0, 101);
    const Cells fine = cellular_noise(p * 52.0, 102);
    const double edge = coarse.second - coarse.nearest;
    const double pebble = smooth_step(-0.25, 0.55, edge) * (0.55 + 0.45 * dome(coarse.nearest / 1.1));
    const double small_edge = smooth_step(-0.2, 0.5, fine.second - fine.nearest);
    const double uneven = static_cast<double>(coarse.id >> 24) / 255.0;
    return pebble * (0.82 + 0.18 * uneven) * (0.85 + 0.15 * small_edge);
}

// The seam on the great circle across `axis`: a groove between two turned-in edges, and thread on both sides.
double sewn(glm::dvec3 d, int axis, double& open) {
    const double across = std::fabs(d[axis]);
    if (across > 0.16) return 0.0;
    const double turns = arc_tangent(d[(axis + 1) % 3], d[(axis + 2) % 3]) / (2.0 * kPi) + 0.5;
    const double stitch = 120.0 * turns - std::floor(120.0 * turns) - 0.5;  // [-0.5, 0.5)
    const double along = stitch / 120.0 * 2.0 * kPi;
    const double slanted = across - 0.062 + 0.25 * along;
    const double r = slanted * slanted / (0.0085 * 0.0085) + along * along / (0.021 * 0.021);
    const double thread = r < 1.0 ? std::sqrt(1.0 - r) : 0.0;
    const double hole = dome(std::sqrt(slanted * slanted + along * along) / 0.034);
    open *= smooth_step(0.03, 0.1, across);  // the grain is stretched smooth at the seam
    const double groove = exponential(-(across * across) / (0.016 * 0.016));
    const double welt = dome((across - 0.04) / 0.035);
    return -0.22 * groove + 0.05 * welt - 0.05 * hole + 0.14 * thread;
}

double leather_height(glm::dvec3 d) {
    double open = 1.0, deepest = 0.0,
           highest = 0.0;  // where seams cross, the deeper groove wins over the other's thread
    for (int axis = 0; axis < 3; ++axis) {
        const double seam = sewn(d, axis, open);
        deepest = std::min(deepest, seam);
        highest = std::max(highest, seam);
    }
    const double seams = deepest + highest * smooth_step(-0.06, 0.0, deepest);
    const double stuffing = 0.06 * fractal_noise(d * 2.2, 3, 111);
    const double least = std::min({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
    const double pillow = 0.1 * smooth_step(0.0, 0.35, least);
    const double pores = 0.006 * noise(d * 130.0, 121);
    return 0.46 + stuffing + pillow + 0.12 * (grain(d) - 0.6) * (0.25 + 0.75 * open) + pores + seams;
}

}  // namespace

Sculpture make_leather() {
    return {make_ball(), [](const Sample& p) { return leather_height(kBall.direction(p.island, p.s, p.t)); }};
}

}  // namespace relievo::assets
