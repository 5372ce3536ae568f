// A scene as its file describes it (DESIGN.md section 6): JSON, "relievo": 1, checked against
// assets/scene.schema.json.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "renderer/scene/mesh.h"

namespace relievo {

enum class Wrap { repeat, clamp };
enum class NormalSource { file, smooth };

// An endless height source made of an exemplar by tiling and blending (renderer/procedural), at
// texture coordinates offset + (uv - 1/2) scale.
struct Procedural {
    static constexpr double kLeastScale = 1e-3, kMostScale = 1e3, kMostOffset = 1e3;
    static constexpr int kMostSeed = 2147483647;
    static constexpr double kLeastTriangle = 1e-3, kMostTriangle = 1e3;

    std::filesystem::path exemplar;  // absolute after loading; a map file, which repeats
    double scale = 1;                // exemplar periods over the unit of uv
    glm::dvec2 offset{0};            // exemplar periods
    std::uint32_t seed = 0;
    double triangle_size = 0.25;  // edge of the blended triangles, exemplar periods
};

struct Displacement {
    std::filesystem::path map;  // absolute after loading; empty: a new flat map of map_size at midlevel
    std::optional<Procedural> procedural;  // instead of a map
    int map_size = 1024;
    double amplitude = 0.1;                    // world units from map value 0 to 1; negative allowed
    double midlevel = 0.5;                     // [0, 1]
    double range_low = 0.0, range_high = 1.0;  // values of a float map that mean 0 and 1
    Wrap wrap = Wrap::repeat;
};

struct Material {
    glm::vec3 albedo{0.6f, 0.57f, 0.53f};  // linear, [0, 1]
    std::filesystem::path albedo_map;      // in the albedo's place; absolute after loading; empty: none
    float roughness = 0.6f;                // [0.02, 1]
    float specular = 0.04f;                // reflectance at normal incidence, [0, 1]; 0 leaves gloss out
};

struct SceneObject {
    std::string name;
    std::filesystem::path mesh_path;
    NormalSource normals = NormalSource::file;
    Displacement displacement;
    Material material;
    std::filesystem::path opacity_map;  // empty: opaque; else 8-bit alpha, under 0.5 is a hole
    glm::dmat4 transform{1.0};
    Mesh mesh;  // filled by load_scene
};

struct Camera {
    glm::dvec3 eye{0, 0, 3}, look_at{0}, up{0, 1, 0};  // world space (not rebased)
    double fov_deg = 40;                               // vertical, (0, 180)
};

struct Light {
    enum class Kind { sun, point } kind = Kind::sun;
    glm::dvec3 direction{-0.5, -1, -0.4};  // sun: the way the light travels
    glm::dvec3 position{0};                // point: world space
    glm::vec3 color{1};                    // linear
    float intensity = 3;                   // sun: irradiance; point: radiant intensity, W/sr
    float angle_deg = 0.5f;                // sun: angular diameter; softens shadows
    float radius = 0;                      // point: sphere radius, world units
};

struct Environment {
    glm::vec3 zenith{0.35f, 0.5f, 0.8f}, horizon{0.8f, 0.82f, 0.85f}, ground{0.25f, 0.22f, 0.2f};
    glm::dvec3 up{0, 1, 0};  // world space, where the zenith lies; of any length but 0
    float intensity = 1;
};

struct ImageSettings {
    int width = 512, height = 512, spp = 16;
};

struct MethodChoice {
    std::string name;                          // empty: the registry's default
    std::map<std::string, double> parameters;  // checked by the renderer's registry, not here
    std::map<std::string, std::string> words{};  // parameters given by a word, which the registry knows
};

struct Scene {
    std::filesystem::path path;  // the file, absolute
    std::vector<SceneObject> objects;
    Camera camera;
    ImageSettings image;
    std::vector<Light> lights;
    Environment environment;
    MethodChoice method;
    glm::dvec3 origin{0};  // world position of the renderer's zero: the centre of all base meshes
    std::vector<std::string> warnings;
};

// Reads and checks a scene file and its meshes, fills every default (a camera that frames the object, sun and
// sky). Throws std::invalid_argument naming file and JSON path (for example `scene.json:
// objects[0].displacement.amplitude: is a string, must be a number`). Unknown keys are errors. Maps are not
// loaded here; that they exist is checked.
Scene load_scene(const std::filesystem::path& path);

// The camera that frames all objects from the front right above, aspect width / height.
Camera framing_camera(const Scene& scene);

}  // namespace relievo
