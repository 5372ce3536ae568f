// A slope of endless broken stone: a sheet whose heights are procedural, and the exemplar that they are made
// of.
#include <algorithm>
#include <cmath>

#include "assets/generator/builders.h"
#include "assets/generator/noise.h"
#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

constexpr Sheet kSheet{28, 28, 1, 9};

glm::dvec3 slope(double s, double t) {
    const double x = 2.4 * (s - 0.5), z = 2.4 * (0.5 - t);
    const double hill =
        0.5 * smooth_step(0.75, -1.1, z) + 0.16 * fractal_noise({x * 1.1, 0.3, z * 1.1}, 3, 301);
    return {x, hill, z};
}

// Stones of one size, `count` a side: flat on top, each tilted and sunk its own way, with dark gaps between.
double stones(double u, double v, std::uint32_t count, std::uint32_t seed) {
    const double warp = 0.35,
                 x = u * count + warp * tiled_noise(u * 2 * count, v * 2 * count, 2 * count, seed + 1),
                 y = v * count + warp * tiled_noise(u * 2 * count, v * 2 * count, 2 * count, seed + 2);
    const Cells c = tiled_cellular_noise(x, y, count, seed);
    const double top = 0.45 + 0.55 * static_cast<double>(c.id >> 20 & 255) / 255.0;
    return top * smooth_step(0.0, 0.42, c.second - c.nearest) * (0.75 + 0.25 * dome(c.nearest / 1.2));
}

double rubble(double u, double v) {
    const double large = stones(u, v, 8, 311), small = stones(u, v, 19, 321), gravel = stones(u, v, 43, 331);
    double rough = 0, size = 0.5;
    for (std::uint32_t octave = 0; octave < 4; ++octave, size *= 0.5) {
        const std::uint32_t period = 24u << octave;
        rough += size * tiled_noise(u * period, v * period, period, 341 + octave);
    }
    // Small stones lie where large ones leave room.
    const double pile = std::max(large, 0.62 * small), filled = std::max(pile, 0.34 * gravel);
    return 0.12 + 0.72 * filled + 0.07 * rough;
}

}  // namespace

Sculpture make_scree() {
    return {make_sheet(kSheet, slope), {}, {}, {}, rubble};
}

}  // namespace relievo::assets
