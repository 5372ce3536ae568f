// The values that a session's `set` command changes, by the key that journals store.
#include "editor/session/settings.h"

#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string_view>

#include "editor/session/text.h"
#include "renderer/methods/registry.h"

namespace relievo {
namespace {

constexpr double kMaxReal = 1e30;
constexpr double kMaxLight = 1e9;

[[noreturn]] void fail(const std::string& key, const std::string& what) {
    throw std::invalid_argument("set " + key + ": " + what);
}

double number(const std::string& key, const SetValue& value, double low, double high) {
    const auto* given = std::get_if<double>(&value);
    if (!given) fail(key, "must be a number");
    if (!(*given >= low && *given <= high))
        fail(key, "is " + number_text(*given) + ", must be " + range_text(low, high));
    return *given;
}

const std::vector<double>& numbers(const std::string& key, const SetValue& value, std::size_t count) {
    const auto* given = std::get_if<std::vector<double>>(&value);
    if (!given || given->size() != count)
        fail(key, "must be an array of " + std::to_string(count) + " numbers");
    for (double item : *given)
        if (!std::isfinite(item) || std::abs(item) > kMaxReal) fail(key, "must hold finite numbers");
    return *given;
}

glm::dvec3 vector(const std::string& key, const SetValue& value) {
    const auto& given = numbers(key, value, 3);
    return {given[0], given[1], given[2]};
}

glm::vec3 color(const std::string& key, const SetValue& value, double high) {
    const glm::dvec3 given = vector(key, value);
    for (int i = 0; i < 3; ++i)
        if (given[i] < 0 || given[i] > high) fail(key, "each part must be " + range_text(0, high));
    return given;
}

float real(const std::string& key, const SetValue& value, double low, double high) {
    return static_cast<float>(number(key, value, low, high));
}

Camera camera_of(const std::string& key, const SetValue& value) {
    const auto& n = numbers(key, value, 10);
    Camera camera{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, n[9]};
    if (!(camera.fov_deg > 0 && camera.fov_deg < 180))
        fail(key, "the field of view must be above 0 and below 180");
    if (glm::length(glm::cross(camera.look_at - camera.eye, camera.up)) == 0)
        fail(key, "eye and look_at must differ, and up must not be along the view");
    return camera;
}

void set_method(MethodChoice& choice, const std::string& key, const SetValue& value) {
    if (key == "method") {
        const auto* name = std::get_if<std::string>(&value);
        if (!name) fail(key, "must be a string: the method's name");
        find_method(*name);
        choice = {*name, {}};
        return;
    }
    const Method& method = choice.name.empty() ? *methods().front() : find_method(choice.name);
    auto parameters = choice.parameters;
    parameters[key.substr(std::string_view("method.").size())] = number(key, value, -kMaxReal, kMaxReal);
    resolve_parameters(method, parameters);
    choice = {std::string(method.name), parameters};
}

void set_material(Material& material, const std::string& key, const SetValue& value) {
    if (key == "material.albedo") {
        material.albedo = color(key, value, 1);
    } else if (key == "material.roughness") {
        material.roughness = real(key, value, 0.02, 1);
    } else if (key == "material.specular") {
        material.specular = real(key, value, 0, 1);
    } else {
        fail(key, "is not a setting; a material has albedo, roughness, specular");
    }
}

void set_light(std::vector<Light>& lights, const std::string& key, const SetValue& value) {
    const auto close = key.find("].");
    const char* first = key.data() + std::string_view("lights[").size();
    std::size_t index = 0;
    const bool numbered = close != std::string::npos &&
                          std::from_chars(first, key.data() + close, index).ptr == key.data() + close;
    if (!numbered || index >= lights.size())
        fail(key,
             "no such light; the scene has " + std::to_string(lights.size()) + ", counted from lights[0]");
    Light& light = lights[index];
    const std::string part = key.substr(close + 2);
    if (part == "direction") {
        const glm::dvec3 direction = vector(key, value);
        if (glm::length(direction) == 0) fail(key, "must not be of length 0");
        light.direction = direction;
    } else if (part == "position") {
        light.position = vector(key, value);
    } else if (part == "color") {
        light.color = color(key, value, kMaxLight);
    } else if (part == "intensity") {
        light.intensity = real(key, value, 0, kMaxLight);
    } else if (part == "angle_deg") {
        light.angle_deg = real(key, value, 0, 90);
    } else if (part == "radius") {
        light.radius = real(key, value, 0, kMaxLight);
    } else {
        fail(key, "is not a setting; a light has direction, position, color, intensity, angle_deg, radius");
    }
}

glm::dvec3 Light::*place_of(const Light& light) {
    return light.kind == Light::Kind::sun ? &Light::direction : &Light::position;
}

void place_lights(Scene& scene, const std::string& key, const SetValue& value) {
    const auto& given = numbers(key, value, 3 * (scene.lights.size() + 1));
    const auto place = [&](std::size_t i) { return glm::dvec3(given[3 * i], given[3 * i + 1], given[3 * i + 2]); };
    std::vector<Light> lights = scene.lights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        lights[i].*place_of(lights[i]) = place(i + 1);
        if (lights[i].kind == Light::Kind::sun && glm::length(lights[i].direction) == 0)
            fail(key, "the direction of lights[" + std::to_string(i) + "] must not be of length 0");
    }
    if (glm::length(place(0)) == 0) fail(key, "environment.up must not be of length 0");
    scene.lights = lights;
    scene.environment.up = place(0);
}

void set_environment(Environment& environment, const std::string& key, const SetValue& value) {
    if (key == "environment.zenith") {
        environment.zenith = color(key, value, kMaxLight);
    } else if (key == "environment.horizon") {
        environment.horizon = color(key, value, kMaxLight);
    } else if (key == "environment.ground") {
        environment.ground = color(key, value, kMaxLight);
    } else if (key == "environment.up") {
        const glm::dvec3 up = vector(key, value);
        if (glm::length(up) == 0) fail(key, "must not be of length 0");
        environment.up = up;
    } else if (key == "environment.intensity") {
        environment.intensity = real(key, value, 0, kMaxLight);
    } else {
        fail(key, "is not a setting; the environment has zenith, horizon, ground, up, intensity");
    }
}

Displacement set_procedural(const Scene& scene, const std::string& key, const SetValue& value) {
    Displacement changed = scene.objects.front().displacement;
    std::optional<Procedural>& source = changed.procedural;
    if (!source) fail(key, "the heights are a map, not procedural");
    if (key == "procedural.exemplar") {
        const auto* file = std::get_if<std::string>(&value);
        if (!file || file->empty()) fail(key, "must be a string: the exemplar's file");
        source->exemplar = (scene.path.parent_path() / *file).lexically_normal();
    } else if (key == "procedural.scale") {
        source->scale = number(key, value, Procedural::kLeastScale, Procedural::kMostScale);
    } else if (key == "procedural.offset") {
        const auto& offset = numbers(key, value, 2);
        for (const double part : offset)
            if (std::abs(part) > Procedural::kMostOffset)
                fail(key, "each part must be " + range_text(-Procedural::kMostOffset, Procedural::kMostOffset));
        source->offset = {offset[0], offset[1]};
    } else if (key == "procedural.seed") {
        const double seed = number(key, value, 0, Procedural::kMostSeed);
        if (seed != std::floor(seed)) fail(key, "must be a whole number");
        source->seed = static_cast<std::uint32_t>(seed);
    } else if (key == "procedural.triangle_size") {
        source->triangle_size = number(key, value, Procedural::kLeastTriangle, Procedural::kMostTriangle);
    } else {
        fail(key, "is not a setting; procedural heights have exemplar, scale, offset, seed, triangle_size");
    }
    return changed;
}

}  // namespace

SettingScope apply_setting(Scene& scene, const std::string& key, const SetValue& value, Displacement& heights) {
    SceneObject& object = scene.objects.front();
    if (key == "amplitude") {
        object.displacement.amplitude = number(key, value, -kMaxReal, kMaxReal);
        return SettingScope::displacement;
    }
    if (key == "midlevel") {
        object.displacement.midlevel = number(key, value, 0, 1);
        return SettingScope::displacement;
    }
    if (key.starts_with("procedural.")) {
        heights = set_procedural(scene, key, value);
        return SettingScope::heights;
    }
    if (key == "camera") {
        scene.camera = camera_of(key, value);
        return SettingScope::camera;
    }
    if (key == "method" || key.starts_with("method.")) {
        set_method(scene.method, key, value);
        return SettingScope::method;
    }
    if (key.starts_with("material.")) {
        set_material(object.material, key, value);
        return SettingScope::material;
    }
    if (key == "lights") {
        place_lights(scene, key, value);
        return SettingScope::lights;
    }
    if (key.starts_with("lights[")) {
        set_light(scene.lights, key, value);
        return SettingScope::lights;
    }
    if (key.starts_with("environment.")) {
        set_environment(scene.environment, key, value);
        return SettingScope::lights;
    }
    fail(key,
         "is not a setting; known are amplitude, midlevel, procedural.*, method, method.PARAMETER, camera, material.*, "
         "lights, lights[I].*, "
         "environment.*");
}

SetValue camera_value(const Camera& camera) {
    return std::vector<double>{camera.eye.x,     camera.eye.y,     camera.eye.z, camera.look_at.x,
                               camera.look_at.y, camera.look_at.z, camera.up.x,  camera.up.y,
                               camera.up.z,      camera.fov_deg};
}

SetValue lights_value(const std::vector<Light>& lights, const glm::dvec3& sky_up) {
    std::vector<double> value{sky_up.x, sky_up.y, sky_up.z};
    for (const Light& light : lights) {
        const glm::dvec3& place = light.*place_of(light);
        value.insert(value.end(), {place.x, place.y, place.z});
    }
    return value;
}

}  // namespace relievo
