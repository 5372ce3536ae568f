// load_scene: the scene file's keys one by one, then its meshes.
#include "renderer/scene/scene.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <stdexcept>

#include "renderer/scene/json_reader.h"
#include "renderer/scene/scene_camera.h"
#include "renderer/scene/scene_keys.h"

namespace relievo {

namespace {

constexpr int kSceneVersion = 1;
constexpr int kMaxMapSize = 16384, kMaxImageSize = 16384, kMaxSamples = 1 << 20;
constexpr std::size_t kMaxItems = 65536;
constexpr NumberRange kUnit{0, 1};
constexpr NumberRange kNotNegative{0, 1e9};
constexpr NumberRange kLength{-1e30, 1e30};
// Scenes nearer to zero than this many of their radii keep plain coordinates.
constexpr double kFarInRadii = 16;

std::filesystem::path file_of(const JsonNode& node, const std::filesystem::path& folder) {
    const std::filesystem::path path = (folder / node.text()).lexically_normal();
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) node.fail("no such file: " + path.string());
    if (std::filesystem::is_directory(status)) node.fail(path.string() + " is a folder, must be a file");
    return path;
}

Procedural read_procedural(const JsonNode& node, const std::filesystem::path& folder) {
    node.require_keys(scene_keys("objects[].displacement.procedural"));
    Procedural p;
    p.exemplar = file_of(node["exemplar"], folder);
    if (node.has("scale")) p.scale = node["scale"].number({Procedural::kLeastScale, Procedural::kMostScale});
    if (node.has("offset")) {
        const JsonNode offset = node["offset"];
        offset.length(2, 2);
        for (int i = 0; i < 2; ++i)
            p.offset[i] = offset[static_cast<std::size_t>(i)].number({-Procedural::kMostOffset, Procedural::kMostOffset});
    }
    if (node.has("seed")) p.seed = static_cast<std::uint32_t>(node["seed"].integer(0, Procedural::kMostSeed));
    if (node.has("triangle_size"))
        p.triangle_size = node["triangle_size"].number({Procedural::kLeastTriangle, Procedural::kMostTriangle});
    return p;
}

Displacement read_displacement(const JsonNode& node, const std::filesystem::path& folder) {
    node.require_keys(scene_keys("objects[].displacement"));
    Displacement d;
    if (node.has("procedural")) {
        for (const char* key : {"map", "size", "wrap"})
            if (node.has(key)) node[key].fail("is for maps; leave out 'procedural' or '" + std::string(key) + "'");
        d.procedural = read_procedural(node["procedural"], folder);
    }
    if (node.has("map")) d.map = file_of(node["map"], folder);
    if (node.has("size")) {
        d.map_size = node["size"].integer(1, kMaxMapSize);
        if (node.has("map")) node["size"].fail("is only for a new map; leave out 'size' or 'map'");
    }
    if (node.has("amplitude")) d.amplitude = node["amplitude"].number(kLength);
    if (node.has("midlevel")) d.midlevel = node["midlevel"].number(kUnit);
    if (node.has("range")) {
        const JsonNode range = node["range"];
        range.length(2, 2);
        d.range_low = range[0].number(kLength);
        d.range_high = range[1].number(kLength);
        if (!(d.range_low < d.range_high)) range.fail("must be [low, high] with low under high");
    }
    constexpr std::string_view kWraps[] = {"repeat", "clamp"};
    if (node.has("wrap")) d.wrap = node["wrap"].one_of(kWraps) == 0 ? Wrap::repeat : Wrap::clamp;
    return d;
}

Material read_material(const JsonNode& node, const std::filesystem::path& folder) {
    node.require_keys(scene_keys("objects[].material"));
    Material m;
    if (node.has("albedo")) m.albedo = glm::vec3(node["albedo"].vector3(kUnit));
    if (node.has("albedo_map")) m.albedo_map = file_of(node["albedo_map"], folder);
    if (node.has("roughness")) m.roughness = static_cast<float>(node["roughness"].number({0.02, 1}));
    if (node.has("specular")) m.specular = static_cast<float>(node["specular"].number(kUnit));
    return m;
}

// 16 numbers by rows, or scale, then rotations about X, Y and Z, then translation.
glm::dmat4 read_transform(const JsonNode& node) {
    glm::dmat4 matrix(1.0);
    if (node.is_array()) {
        node.length(16, 16);
        for (int i = 0; i < 16; ++i) matrix[i % 4][i / 4] = node[static_cast<std::size_t>(i)].number(kLength);
        for (int k = 0; k < 4; ++k) {
            if (matrix[k][3] != (k == 3 ? 1.0 : 0.0)) node.fail("the last row must be 0, 0, 0, 1");
        }
    } else {
        node.require_keys(scene_keys("objects[].transform"));
        if (node.has("translate")) matrix = glm::translate(matrix, node["translate"].vector3(kLength));
        if (node.has("rotate_deg")) {
            const glm::dvec3 angles = glm::radians(node["rotate_deg"].vector3({-1e6, 1e6}));
            matrix = glm::rotate(matrix, angles.z, glm::dvec3(0, 0, 1));
            matrix = glm::rotate(matrix, angles.y, glm::dvec3(0, 1, 0));
            matrix = glm::rotate(matrix, angles.x, glm::dvec3(1, 0, 0));
        }
        if (node.has("scale")) {
            const JsonNode scale = node["scale"];
            const glm::dvec3 factors =
                scale.is_array() ? scale.vector3(kLength) : glm::dvec3(scale.number(kLength));
            matrix = glm::scale(matrix, factors);
        }
    }
    const glm::dmat3 linear(matrix);
    const double sizes = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
    if (!(std::abs(glm::determinant(linear)) > 1e-12 * sizes))
        node.fail("flattens the object; it cannot be inverted");
    return matrix;
}

SceneObject read_object(const JsonNode& node, const std::filesystem::path& folder) {
    node.require_keys(scene_keys("objects[]"));
    SceneObject object;
    object.mesh_path = file_of(node["mesh"], folder);
    object.name = node.has("name") ? node["name"].text() : object.mesh_path.stem().string();
    constexpr std::string_view kNormals[] = {"file", "smooth"};
    if (node.has("normals") && node["normals"].one_of(kNormals) == 1) object.normals = NormalSource::smooth;
    if (node.has("displacement")) object.displacement = read_displacement(node["displacement"], folder);
    if (node.has("material")) object.material = read_material(node["material"], folder);
    if (node.has("opacity_map")) object.opacity_map = file_of(node["opacity_map"], folder);
    if (node.has("transform")) object.transform = read_transform(node["transform"]);
    return object;
}

Light read_light(const JsonNode& node) {
    constexpr std::string_view kTypes[] = {"sun", "point"};
    node.keys();  // must be an object before its type is asked for
    Light light;
    light.kind = node["type"].one_of(kTypes) == 0 ? Light::Kind::sun : Light::Kind::point;
    const bool is_sun = light.kind == Light::Kind::sun;
    node.require_keys(scene_keys(is_sun ? "lights[] sun" : "lights[] point"));
    if (is_sun && node.has("direction")) {
        light.direction = node["direction"].vector3(kLength);
        if (!(glm::length(light.direction) > 0)) node["direction"].fail("has no length");
    }
    if (!is_sun) light.position = node["position"].vector3(kLength);
    if (node.has("color")) light.color = glm::vec3(node["color"].vector3(kNotNegative));
    if (node.has("intensity")) light.intensity = static_cast<float>(node["intensity"].number(kNotNegative));
    if (node.has("angle_deg")) light.angle_deg = static_cast<float>(node["angle_deg"].number({0, 90}));
    if (node.has("radius")) light.radius = static_cast<float>(node["radius"].number(kNotNegative));
    return light;
}

Environment read_environment(const JsonNode& node) {
    node.require_keys(scene_keys("environment"));
    Environment e;
    if (node.has("zenith")) e.zenith = glm::vec3(node["zenith"].vector3(kNotNegative));
    if (node.has("horizon")) e.horizon = glm::vec3(node["horizon"].vector3(kNotNegative));
    if (node.has("ground")) e.ground = glm::vec3(node["ground"].vector3(kNotNegative));
    if (node.has("up")) {
        e.up = node["up"].vector3(kLength);
        if (!(glm::length(e.up) > 0)) node["up"].fail("has no length");
    }
    if (node.has("intensity")) e.intensity = static_cast<float>(node["intensity"].number(kNotNegative));
    return e;
}

ImageSettings read_image(const JsonNode& node) {
    node.require_keys(scene_keys("image"));
    ImageSettings image;
    if (node.has("width")) image.width = node["width"].integer(1, kMaxImageSize);
    if (node.has("height")) image.height = node["height"].integer(1, kMaxImageSize);
    if (node.has("spp")) image.spp = node["spp"].integer(1, kMaxSamples);
    return image;
}

// Parameter names and ranges are the method registry's business; a switch is 0 or 1.
MethodChoice read_method(const JsonNode& node) {
    MethodChoice method;
    for (const std::string& key : node.keys()) {
        const JsonNode value = node[key];
        if (key == "name") {
            method.name = value.text();
        } else if (value.is_text()) {
            method.words[key] = value.text();
        } else {
            method.parameters[key] = value.is_boolean() ? (value.boolean() ? 1.0 : 0.0) : value.number();
        }
    }
    return method;
}

// Reads each object's file and finds the origin, then makes the meshes.
void load_meshes(const JsonNode& objects, Scene& scene) {
    std::map<std::filesystem::path, MeshFile> files;
    glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const SceneObject& object = scene.objects[i];
        try {
            if (!files.contains(object.mesh_path)) files[object.mesh_path] = load_mesh_file(object.mesh_path);
        } catch (const std::invalid_argument& e) {
            objects[i]["mesh"].fail(e.what());
        }
        for (const glm::dvec3& p : files[object.mesh_path].positions) {
            const glm::dvec3 world(object.transform * glm::dvec4(p, 1));
            low = glm::min(low, world);
            high = glm::max(high, world);
        }
    }
    const glm::dvec3 centre = (low + high) * 0.5;
    const double radius = glm::length(high - low) * 0.5;
    scene.origin = glm::length(centre) < kFarInRadii * radius ? glm::dvec3(0) : centre;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        SceneObject& object = scene.objects[i];
        try {
            object.mesh = make_mesh(files[object.mesh_path], object.transform, scene.origin,
                                    object.normals == NormalSource::file);
        } catch (const std::invalid_argument& e) {
            objects[i]["mesh"].fail(e.what());
        }
        for (const std::string& warning : object.mesh.warnings) {
            scene.warnings.push_back(object.mesh_path.string() + ": " + warning);
        }
    }
}

}  // namespace

Scene load_scene(const std::filesystem::path& path) {
    const JsonDocument document(path);
    const JsonNode root = document.root();
    root.require_keys(scene_keys(""));
    if (const int version = root["relievo"].integer(1, 1 << 30); version != kSceneVersion) {
        root["relievo"].fail("is " + std::to_string(version) + ", this version reads scenes of version 1");
    }
    if (root.has("$schema")) root["$schema"].text();

    Scene scene;
    scene.path = std::filesystem::absolute(path).lexically_normal();
    const JsonNode objects = root["objects"];
    const std::size_t count = objects.length(1, kMaxItems);
    for (std::size_t i = 0; i < count; ++i) {
        scene.objects.push_back(read_object(objects[i], scene.path.parent_path()));
    }
    if (root.has("image")) scene.image = read_image(root["image"]);
    scene.lights.emplace_back();
    if (root.has("lights")) {
        const JsonNode lights = root["lights"];
        scene.lights.clear();
        for (std::size_t i = 0; i < lights.length(0, kMaxItems); ++i)
            scene.lights.push_back(read_light(lights[i]));
    }
    if (root.has("environment")) scene.environment = read_environment(root["environment"]);
    if (root.has("method")) scene.method = read_method(root["method"]);
    load_meshes(objects, scene);
    scene.camera = root.has("camera") ? read_camera(root["camera"], scene) : framing_camera(scene);
    return scene;
}

}  // namespace relievo
