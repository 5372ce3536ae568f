// Framing: the bounding sphere of all objects, grown by how far each can be displaced, fills the smaller half
// angle.
#include "renderer/scene/scene_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "renderer/scene/scene_keys.h"

namespace relievo {

namespace {

constexpr double kMargin = 1.05;
constexpr NumberRange kLength{-1e30, 1e30};
const glm::dvec3 kFrontRightAbove = glm::normalize(glm::dvec3(0.5, 0.5, 1.0));

struct Sphere {
    glm::dvec3 centre{0};  // world space
    double radius = 1;
};

// How far a displaced point can leave the base mesh.
double reach(const Displacement& d) {
    return std::abs(d.amplitude) * std::max(d.midlevel, 1 - d.midlevel);
}

Sphere framed_sphere(const Scene& scene) {
    if (scene.objects.empty()) return {};
    glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
    for (const SceneObject& object : scene.objects) {
        low = glm::min(low, glm::dvec3(object.mesh.bounds_low));
        high = glm::max(high, glm::dvec3(object.mesh.bounds_high));
    }
    const glm::dvec3 centre = (low + high) * 0.5;
    double radius = 0;
    for (const SceneObject& object : scene.objects) {
        const double away = glm::length(glm::dvec3(object.mesh.sphere_centre) - centre);
        radius = std::max(radius,
                          away + static_cast<double>(object.mesh.sphere_radius) + reach(object.displacement));
    }
    return {scene.origin + centre, radius > 0 ? radius : 1};
}

// Distance from the sphere's centre at which the whole sphere is seen.
double framing_distance(const Sphere& sphere, const Scene& scene, double fov_deg) {
    const double vertical = glm::radians(fov_deg) / 2;
    const double aspect = static_cast<double>(scene.image.width) / static_cast<double>(scene.image.height);
    const double horizontal = std::atan(std::tan(vertical) * aspect);
    return kMargin * sphere.radius / std::sin(std::min(vertical, horizontal));
}

bool are_parallel(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(glm::cross(glm::normalize(a), glm::normalize(b))) < 1e-6;
}

}  // namespace

Camera framing_camera(const Scene& scene) {
    Camera camera;
    camera.fov_deg = scene.camera.fov_deg;
    const Sphere sphere = framed_sphere(scene);
    camera.look_at = sphere.centre;
    camera.eye = sphere.centre + kFrontRightAbove * framing_distance(sphere, scene, camera.fov_deg);
    return camera;
}

Camera read_camera(const JsonNode& node, const Scene& scene) {
    node.require_keys(scene_keys("camera"));
    Scene framed;
    framed.objects = scene.objects;
    framed.origin = scene.origin;
    framed.image = scene.image;
    if (node.has("fov_deg")) framed.camera.fov_deg = node["fov_deg"].number({0, 180, true});
    Camera camera = framing_camera(framed);
    const glm::dvec3 offset = camera.eye - camera.look_at;
    if (node.has("look_at")) camera.look_at = node["look_at"].vector3(kLength);
    camera.eye = node.has("eye") ? node["eye"].vector3(kLength) : camera.look_at + offset;
    const glm::dvec3 view = camera.look_at - camera.eye;
    if (!(glm::length(view) > 0)) node.fail("eye and look_at are the same point");
    if (node.has("up")) {
        camera.up = node["up"].vector3(kLength);
        if (!(glm::length(camera.up) > 0)) node["up"].fail("has no length");
        if (are_parallel(camera.up, view)) node["up"].fail("points along the view, must point across it");
    } else if (are_parallel(camera.up, view)) {
        camera.up = {0, 0, -1};
    }
    return camera;
}

}  // namespace relievo
