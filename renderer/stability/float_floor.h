// What a method that works in float can be asked for.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <vector>

#include "renderer/judge/error_units.h"
#include "renderer/stability/stability_case.h"

namespace relievo::stability {

// The units that depth errors of a view are told in. They are the amplitude (error_units.h), but never so
// short that the promised 1e-5 of one would be less than what rounding takes: the eye, the ray's direction
// and the depth are floats, each off by half a unit in the last place of the coordinates met. `eye`: of the
// rays, rebased; `reach`: how far they go.
inline std::vector<ErrorUnit> float_units(const Case& c, const glm::dvec3& eye, double reach) {
    constexpr double kRoundings = 2, kHalfUlp = 0x1p-24, kPromise = 1e-5;
    const double largest = std::max({std::abs(eye.x), std::abs(eye.y), std::abs(eye.z)}) + reach;
    const double floor = kRoundings * kHalfUlp * largest / kPromise;
    std::vector<ErrorUnit> units;
    for (const SampleSurface& surface : c.objects) {
        ErrorUnit unit = error_unit(surface.amplitude, surface.mesh);
        if (unit.length < floor) unit = {floor, false};
        units.push_back(unit);
    }
    return units;
}

}  // namespace relievo::stability
