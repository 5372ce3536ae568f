// The determinant of two vectors of a plane: the area of their parallelogram, positive where b lies to the left of a.
#pragma once

#include <glm/vec2.hpp>

namespace relievo {

inline double cross2(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

}  // namespace relievo
