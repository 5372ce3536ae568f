// The length that depth errors of an object are told in.
#pragma once

#include <string_view>
#include <vector>

#include "renderer/scene/scene.h"

namespace relievo {

struct ErrorUnit {
    double length = 1;  // world units, above 0
    // An object without displacement has no amplitude to compare with: its errors are told in a hundredth of
    // its bounding sphere's radius.
    bool is_amplitude = true;

    std::string_view name() const { return is_amplitude ? "amplitude" : "radius / 100"; }
};

ErrorUnit error_unit(double amplitude, const Mesh& mesh);
std::vector<ErrorUnit> error_units(const Scene& scene);  // one an object

}  // namespace relievo
