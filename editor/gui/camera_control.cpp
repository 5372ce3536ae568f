// Moving the camera around its look_at point.
#include "editor/gui/camera_control.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace relievo::gui {
namespace {

constexpr double kOrbitPerHeight = 3.5;  // radians for a drag over the picture's height
constexpr double kSteepestDeg = 89.5;    // the view never reaches the up vector, where left and right end
constexpr double kZoomPerNotch = 0.88;
constexpr double kNearest = 1e-3, kFurthest = 100;  // from look_at, over the scene's radius
constexpr double kFrameMargin = 1.12;

struct Ball {
    glm::dvec3 centre;  // rebased
    double radius;
};

// Holds all objects with their relief.
Ball ball_around(const Scene& scene) {
    glm::dvec3 low(1e300), high(-1e300);
    double swell = 0;
    for (const SceneObject& object : scene.objects) {
        low = glm::min(low, glm::dvec3(object.mesh.bounds_low));
        high = glm::max(high, glm::dvec3(object.mesh.bounds_high));
        const Displacement& d = object.displacement;
        swell = std::max(swell, std::abs(d.amplitude) * std::max(d.midlevel, 1 - d.midlevel));
    }
    return {(low + high) * 0.5, glm::length(high - low) * 0.5 + swell};
}

// Directions around the up vector: right of a viewer at `front`.
struct Axes {
    glm::dvec3 up, right, front;
};

Axes axes_of(const Camera& camera) {
    const glm::dvec3 up = glm::normalize(camera.up);
    const glm::dvec3 x = std::abs(up.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 right = glm::normalize(x - up * glm::dot(x, up));
    return {up, right, glm::cross(right, up)};
}

// The camera at longitude and latitude (radians) about look_at.
Camera at_angles(const Camera& camera, double longitude, double latitude) {
    const Axes axes = axes_of(camera);
    const double steepest = glm::radians(kSteepestDeg);
    latitude = std::clamp(latitude, -steepest, steepest);
    const glm::dvec3 level = axes.front * std::cos(longitude) + axes.right * std::sin(longitude);
    Camera turned = camera;
    turned.eye = camera.look_at + (level * std::cos(latitude) + axes.up * std::sin(latitude)) *
                                      glm::length(camera.eye - camera.look_at);
    return turned;
}

struct Angles {
    double longitude, latitude;
};

Angles angles_of(const Camera& camera) {
    const Axes axes = axes_of(camera);
    const glm::dvec3 out = glm::normalize(camera.eye - camera.look_at);
    return {std::atan2(glm::dot(out, axes.right), glm::dot(out, axes.front)),
            std::asin(std::clamp(glm::dot(out, axes.up), -1.0, 1.0))};
}

}  // namespace

Camera orbited(const Camera& camera, double dx_px, double dy_px, int height_px) {
    const Angles angles = angles_of(camera);
    const double scale = kOrbitPerHeight / height_px;
    return at_angles(camera, angles.longitude - dx_px * scale, angles.latitude + dy_px * scale);
}

Camera panned(const Camera& camera, double dx_px, double dy_px, int height_px) {
    const glm::dvec3 forward = camera.look_at - camera.eye;
    const double unit_per_px =
        2 * glm::length(forward) * std::tan(glm::radians(camera.fov_deg) / 2) / height_px;
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::normalize(glm::cross(right, forward));
    const glm::dvec3 shift = (up * dy_px - right * dx_px) * unit_per_px;
    Camera moved = camera;
    moved.eye += shift;
    moved.look_at += shift;
    return moved;
}

Camera zoomed(const Camera& camera, double notches, const Scene& scene) {
    const double radius = ball_around(scene).radius;
    const double distance = glm::length(camera.eye - camera.look_at);
    // A scene may begin beyond the ends.
    const double nearest = std::min(kNearest * radius, distance), furthest = std::max(kFurthest * radius, distance);
    const double wanted = std::clamp(distance * std::pow(kZoomPerNotch, notches), nearest, furthest);
    Camera moved = camera;
    moved.eye = camera.look_at + (camera.eye - camera.look_at) * (wanted / distance);
    return moved;
}

Camera with_fov(const Camera& camera, double fov_deg) {
    const double scale = std::tan(glm::radians(camera.fov_deg) / 2) / std::tan(glm::radians(fov_deg) / 2);
    Camera moved = camera;
    moved.fov_deg = fov_deg;
    moved.eye = camera.look_at + (camera.eye - camera.look_at) * scale;
    return moved;
}

Camera looking_along(const Camera& camera, Axis axis) {
    const double quarter = glm::radians(90.0);
    const Angles now = angles_of(camera);
    Angles wanted{axis == Axis::right ? quarter : 0.0, axis == Axis::top ? quarter : 0.0};
    const auto near = [](double a, double b) {
        return std::abs(std::remainder(a - b, glm::radians(360.0))) < 0.02;
    };
    if (axis == Axis::top && near(now.latitude, glm::radians(kSteepestDeg))) wanted.latitude = -quarter;
    if (axis != Axis::top && near(now.longitude, wanted.longitude) && near(now.latitude, 0))
        wanted.longitude += 2 * quarter;
    return at_angles(camera, wanted.longitude, wanted.latitude);
}

Camera framing_all(const Scene& scene, PixelSize picture) {
    const Ball ball = ball_around(scene);
    const Camera& camera = scene.camera;
    const double half_height = std::tan(glm::radians(camera.fov_deg) / 2);
    const double half_least =
        half_height * std::min(1.0, static_cast<double>(picture.width) / picture.height);
    const double distance = kFrameMargin * ball.radius / std::sin(std::atan(half_least));
    Camera framed = camera;
    framed.look_at = ball.centre + scene.origin;
    framed.eye = framed.look_at + glm::normalize(camera.eye - camera.look_at) * distance;
    return framed;
}

}  // namespace relievo::gui
