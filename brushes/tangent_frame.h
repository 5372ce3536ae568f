// A frame on the surface: two directions along it, and its normal.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace relievo {

struct TangentFrame {  // right-handed, unit
    glm::dvec3 right, up, normal;
};

// The frame across a unit normal whose right lies as near as can be to `right`. Where that says nothing (it
// is zero or along the normal), the x axis does, and near that the z axis turned round: a plane across z has
// x and y.
inline TangentFrame tangent_frame(glm::dvec3 normal, glm::dvec3 right = glm::dvec3(0)) {
    constexpr double kLeast = 1e-6;
    glm::dvec3 up = glm::cross(normal, right);
    if (!(glm::length(up) > kLeast))
        up = glm::cross(normal, std::abs(normal.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, -1));
    up = glm::normalize(up);
    return {glm::cross(up, normal), up, normal};
}

// Turned about its normal, anticlockwise as seen from outside.
inline TangentFrame turned(const TangentFrame& frame, double degrees) {
    const double angle = degrees * (3.14159265358979323846 / 180.0);
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * frame.right + s * frame.up, c * frame.up - s * frame.right, frame.normal};
}

}  // namespace relievo
