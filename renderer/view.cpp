// See view.h.
#include "renderer/view.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <stdexcept>

namespace relievo {

void fill_view(gpu::FrameData& frame, const Camera& camera, const glm::dvec3& origin, int width, int height) {
    const glm::dvec3 forward = glm::normalize(camera.look_at - camera.eye);
    glm::dvec3 right = glm::cross(forward, camera.up);
    // Looking straight along `up`: any other axis serves.
    if (glm::length(right) < 1e-9 * glm::length(camera.up))
        right = glm::cross(forward, std::abs(forward.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1));
    right = glm::normalize(right);
    const double half_height = std::tan(glm::radians(camera.fov_deg) / 2);
    frame.eye = glm::vec3(camera.eye - origin);
    frame.forward = glm::vec3(forward);
    frame.right = glm::vec3(right * (half_height * width / height));
    frame.up = glm::vec3(glm::cross(right, forward) * half_height);
    frame.size = {width, height};
}

void fill_lights(gpu::FrameData& frame, const std::vector<Light>& lights, const Environment& environment,
                 const glm::dvec3& origin) {
    frame.light_count = 0;
    for (const Light& light : lights) {
        if (!(light.intensity > 0)) continue;
        if (frame.light_count == gpu::kMaxLights)
            throw std::invalid_argument("the scene has more than " + std::to_string(gpu::kMaxLights) + " lights");
        gpu::LightData& data = frame.lights[frame.light_count++];
        data.radiance = light.color * light.intensity;
        if (light.kind == Light::Kind::sun) {
            data.position = glm::vec3(-glm::normalize(light.direction));
            data.size = static_cast<float>(std::tan(glm::radians(double{light.angle_deg}) / 2));
            data.is_point = 0;
        } else {
            data.position = glm::vec3(light.position - origin);
            data.size = light.radius;
            data.is_point = 1;
        }
    }
    frame.zenith = environment.zenith * environment.intensity;
    frame.horizon = environment.horizon * environment.intensity;
    frame.ground = environment.ground * environment.intensity;
    frame.sky_up = glm::vec3(glm::normalize(environment.up));
}

Ray ray_through(const gpu::FrameData& frame, double x_px, double y_px) {
    const float x = static_cast<float>(x_px) / static_cast<float>(frame.size.x) * 2.0f - 1.0f;
    const float y = static_cast<float>(y_px) / static_cast<float>(frame.size.y) * 2.0f - 1.0f;
    return {frame.eye, glm::normalize(frame.forward + frame.right * x - frame.up * y)};
}

}  // namespace relievo
