// See error_units.h.
#include "renderer/judge/error_units.h"

#include <cmath>

namespace relievo {

ErrorUnit error_unit(double amplitude, const Mesh& mesh) {
    if (amplitude != 0 && std::isfinite(amplitude)) return {std::abs(amplitude), true};
    const double radius = static_cast<double>(mesh.sphere_radius);
    return {radius > 0 ? radius / 100 : 1, false};
}

std::vector<ErrorUnit> error_units(const Scene& scene) {
    std::vector<ErrorUnit> units;
    for (const SceneObject& object : scene.objects)
        units.push_back(error_unit(object.displacement.amplitude, object.mesh));
    return units;
}

}  // namespace relievo
