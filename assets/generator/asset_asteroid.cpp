// A lump of 480 triangles, cratered. Its islands are a box's faces, one of them turned by 90 degrees.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "assets/generator/builders.h"
#include "assets/generator/noise.h"
#include "assets/generator/portable_math.h"

namespace relievo::assets {
namespace {

struct Crater {
    glm::dvec3 centre;  // unit
    double radius;      // radians
    double depth;       // of the map's range
};

std::vector<Crater> make_craters() {
    std::vector<Crater> craters;
    constexpr int kCount = 240;
    for (int i = 0; i < kCount; ++i) {
        const auto n = static_cast<std::uint32_t>(i);
        const double rank = (i + 1.0) / kCount;  // few large ones, many small ones
        const double radius = 0.045 + 0.42 * exponential(-7.0 * rank) + 0.03 * hash01(n, 0, 0, 31);
        // The order of the spiral is shuffled (7 and 240 share no factor), or the large ones would sit at the
        // pole.
        craters.push_back(
            {scattered_direction(i * 77 % kCount, kCount, 32), radius, (0.7 - 0.6 * radius) * radius});
    }
    return craters;
}

// A bowl with a raised, slightly terraced rim and a fading blanket; r = distance / radius.
double crater_profile(double r) {
    const double bowl = r < 1.0 ? -1.0 + 1.25 * r * r * (1.0 + 0.12 * dome((r - 0.72) / 0.12)) : 0.0;
    const double rim = r < 1.0 ? 0.0 : 0.25 * exponential(-5.0 * (r - 1.0));
    return r < 1.0 ? std::min(bowl, 0.25) : rim;
}

double cratered_height(const std::vector<Crater>& craters, glm::dvec3 d) {
    const glm::dvec3 warp{noise(d * 7.0, 41), noise(d * 7.0, 42), noise(d * 7.0, 43)};
    const glm::dvec3 p = glm::normalize(d + 0.012 * warp);
    double height = 0.0;
    for (const Crater& c : craters) {
        const double reach = 2.2 * c.radius;
        const double distance = glm::distance(p, c.centre);
        if (distance >= reach) continue;
        const double r = distance / c.radius;
        // A young crater wipes out what lay in its bowl.
        height = height * smooth_step(0.7, 1.15, r) + c.depth * crater_profile(r) * smooth_step(2.2, 1.4, r);
    }
    const double rock = fractal_noise(d * 2.5, 7, 51);
    const double rubble = ridged_noise(d * 17.0, 4, 61);
    return 0.5 + height + 0.07 * rock + 0.02 * (rubble - 0.5);
}

glm::dvec3 lump(glm::dvec3 d) {
    const double r = 0.92 + 0.2 * fractal_noise(d * 1.1 + glm::dvec3(4.2, 0.3, 1.7), 2, 71);
    return r * glm::dvec3(1.12, 0.86, 0.94) * d;
}

}  // namespace

Sculpture make_asteroid() {
    const BoxSphere box{{6, 7, 6}};
    constexpr int kCell = 13;
    constexpr int kSide = 6 * kCell, kTall = 7 * kCell, kStep = kSide + kGap;
    const std::array<Place, 6> places{{
        {2, 2},
        {2 + kStep, 2},
        {2 + 2 * kStep, 2 + kTall + kGap},
        {2 + kStep, 2 + kTall + kGap, true},
        {2, 2 + kTall + kGap},
        {2 + 2 * kStep, 2},
    }};
    Shape shape = make_box_sphere(box, places, kCell, lump);
    shape.make_normals();
    return {std::move(shape), [box, craters = make_craters()](const Sample& p) {
                return cratered_height(craters, box.direction(p.island, p.s, p.t));
            }};
}

}  // namespace relievo::assets
