// Two triangles over the whole map: dunes before a cliff.
#include <cmath>

#include "assets/generator/builders.h"
#include "assets/generator/noise.h"
#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

// Wind-blown sand: a long rise and a short slip face, bent by noise. x and z in [-1, 1].
double dunes(double x, double z) {
    const double bend = fractal_noise({x * 1.3, 0.0, z * 1.3}, 3, 11);
    const double phase = 3.1 * z + 0.9 * x + 1.1 * bend;
    const double wave = phase - std::floor(phase);
    const double crest = wave < 0.72 ? smooth_step(0.0, 0.72, wave) : smooth_step(1.0, 0.68, wave);
    const double fade = 0.55 + 0.45 * noise({x * 1.7 + 5.0, 0.0, z * 1.7}, 12);
    const double ripple_phase = 62.0 * (z + 0.35 * x) + 9.0 * noise({x * 3.0, 1.0, z * 3.0}, 13);
    return 0.11 * crest * fade + 0.0035 * sine(ripple_phase) * (1.0 - crest * 0.6);
}

// A mesa with a wall one texel wide, terraced, and scree at its foot.
double cliff(double x, double z, double sand) {
    const double edge = -0.28 + 0.2 * fractal_noise({x * 1.6, 3.0, z * 0.4}, 5, 21) + 0.22 * x;
    const double inside = edge - z;  // over 0 on the mesa
    const double terrace = inside - 0.13 - 0.07 * noise({x * 2.3, 7.0, 0.0}, 22);
    const double rock = 0.016 * ridged_noise({x * 9.0, 0.0, z * 9.0}, 5, 23);
    if (inside > 0.0)
        return 0.55 + rock + (terrace > 0.0 ? 0.12 : 0.0) + 0.03 * smooth_step(0.0, 0.5, inside);
    const double scree = dome(inside / 0.14) * (0.06 + 0.05 * noise({x * 30.0, 0.0, z * 30.0}, 24));
    return 0.3 + sand + (inside > -0.14 ? scree : 0.0);
}

}  // namespace

Sculpture make_plane() {
    Shape shape;
    for (const double z : {1.0, -1.0})
        for (const double x : {-1.0, 1.0}) shape.positions.push_back({x, 0.0, z});
    shape.add_island({1, 1, 0, 0, kLattice, kLattice},
                     [](int column, int row) { return static_cast<std::uint32_t>(2 * row + column); });
    shape.make_normals();
    return {shape, [](const Sample& p) {
                const double x = 2.0 * p.s - 1.0, z = 1.0 - 2.0 * p.t;
                return cliff(x, z, dunes(x, z));
            }};
}

}  // namespace relievo::assets
