// Where a point of the scene stands in the picture: for the live window around the brush.
#include "editor/session/view_window.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace relievo {

std::optional<glm::dvec2> project(const Camera& camera, const glm::dvec3& origin, int width, int height,
                                  const glm::vec3& point) {
    const glm::dvec3 forward = glm::normalize(camera.look_at - camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const glm::dvec3 from_eye = glm::dvec3(point) + origin - camera.eye;
    const double depth = glm::dot(from_eye, forward);
    if (!(depth > 0)) return std::nullopt;
    const double pixels_per_slope = 0.5 * height / std::tan(glm::radians(camera.fov_deg) / 2);
    return glm::dvec2{0.5 * width + glm::dot(from_eye, right) / depth * pixels_per_slope,
                      0.5 * height - glm::dot(from_eye, up) / depth * pixels_per_slope};
}

PixelRect window_around(const glm::dvec2& centre_px, int size, int width, int height) {
    const auto start = [size](double centre, int limit) {
        const double first =
            std::clamp(centre - 0.5 * size, 0.0, static_cast<double>(std::max(0, limit - size)));
        return static_cast<int>(std::floor(first));
    };
    const int x0 = start(centre_px.x, width), y0 = start(centre_px.y, height);
    return {x0, y0, std::min(width, x0 + size), std::min(height, y0 + size)};
}

}  // namespace relievo
