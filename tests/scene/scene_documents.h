// Scene documents, good and bad, that the loader and the schema must judge alike. quad.obj lies beside them.
#pragma once

#include <string>
#include <string_view>

namespace relievo {

enum class Verdict { good, bad, bad_beyond_schema };

struct SceneDocument {
    Verdict verdict;
    std::string_view
        json;  // what `with` stands for inside {"relievo": 1, "objects": [{"mesh": "quad.obj"}] ...}
    std::string_view message;  // after the file's name; empty: not compared
};

// `json` of the table is either a whole document (starts with '{' or '[') or a top-level entry to add.
inline std::string whole_document(std::string_view json) {
    if (json.starts_with('{') || json.starts_with('[')) return std::string(json);
    if (json.starts_with("object ")) {
        return R"({"relievo": 1, "objects": [{"mesh": "quad.obj", )" + std::string(json.substr(7)) + "}]}";
    }
    return R"({"relievo": 1, "objects": [{"mesh": "quad.obj"}], )" + std::string(json) + "}";
}

inline constexpr SceneDocument kSceneDocuments[] = {
    {Verdict::good, R"({"relievo": 1, "objects": [{"mesh": "quad.obj"}]})", ""},
    {Verdict::good, R"({"$schema": "scene.schema.json", "relievo": 1.0, "objects": [{"mesh": "quad.obj"}]})",
     ""},
    {Verdict::bad, R"([])", "is an array, must be an object"},
    {Verdict::bad, R"({})", "the key 'relievo' is missing"},
    {Verdict::bad, R"({"relievo": 1})", "the key 'objects' is missing"},
    {Verdict::bad, R"({"relievo": 2, "objects": [{"mesh": "quad.obj"}]})",
     "relievo: is 2, this version reads scenes of version 1"},
    {Verdict::bad, R"({"relievo": "1", "objects": [{"mesh": "quad.obj"}]})",
     "relievo: is a string, must be a number"},
    {Verdict::bad, R"({"relievo": 1, "objects": []})", "objects: has 0 items, must have at least 1"},
    {Verdict::bad, R"({"relievo": 1, "objects": {}})", "objects: is an object, must be an array"},
    {Verdict::bad, R"({"relievo": 1, "objects": [3]})", "objects[0]: is a number, must be an object"},
    {Verdict::bad, R"({"relievo": 1, "objects": [{}]})", "objects[0]: the key 'mesh' is missing"},
    {Verdict::bad, R"({"relievo": 1, "objects": [{"mesh": 3}]})",
     "objects[0].mesh: is a number, must be a string"},
    {Verdict::bad, R"({"relievo": 1, "objects": [{"mesh": ""}]})", "objects[0].mesh: is an empty string"},
    {Verdict::bad, R"("objetcs": 1)",
     "objetcs: unknown key; did you mean 'objects'? (known: $schema, relievo, objects, "
     "camera, image, lights, environment, method)"},
    {Verdict::bad, R"("camera": null)", "camera: is null, must be an object"},

    {Verdict::good, R"(object "name": "quad", "normals": "smooth")", ""},
    {Verdict::bad, R"(object "name": 7)", "objects[0].name: is a number, must be a string"},
    {Verdict::bad, R"(object "normals": "flat")",
     "objects[0].normals: is 'flat', must be 'file' or 'smooth'"},
    {Verdict::bad, R"(object "displacment": {})",
     "objects[0].displacment: unknown key; did you mean 'displacement'? (known: name, mesh, normals, "
     "displacement, "
     "material, opacity_map, transform)"},
    {Verdict::bad, R"(object "opacity_map": false)",
     "objects[0].opacity_map: is true or false, must be a string"},

    {Verdict::good, R"(object "displacement": {})", ""},
    {Verdict::good,
     R"(object "displacement": {"size": 16384, "amplitude": -3e-6, "midlevel": 1, "range": [-1, 2], "wrap": "clamp"})",
     ""},
    {Verdict::good, R"(object "displacement": {"map": "quad.obj"})", ""},
    {Verdict::bad, R"(object "displacement": {"amplitude": "0.1"})",
     "objects[0].displacement.amplitude: is a string, must be a number"},
    {Verdict::bad, R"(object "displacement": {"midlevel": 1.5})",
     "objects[0].displacement.midlevel: is 1.5, must be in [0, 1]"},
    {Verdict::bad, R"(object "displacement": {"size": 0})",
     "objects[0].displacement.size: is 0, must be in [1, 16384]"},
    {Verdict::bad, R"(object "displacement": {"size": 10.5})",
     "objects[0].displacement.size: is 10.5, must be a whole number"},
    {Verdict::bad, R"(object "displacement": {"map": "quad.obj", "size": 64})",
     "objects[0].displacement.size: is only for a new map; leave out 'size' or 'map'"},
    {Verdict::bad, R"(object "displacement": {"range": [0]})",
     "objects[0].displacement.range: has 1 items, must have 2"},
    {Verdict::bad_beyond_schema, R"(object "displacement": {"range": [1, 1]})",
     "objects[0].displacement.range: must be [low, high] with low under high"},
    {Verdict::bad, R"(object "displacement": {"wrap": "mirror"})",
     "objects[0].displacement.wrap: is 'mirror', must be 'repeat' or 'clamp'"},
    {Verdict::good, R"(object "displacement": {"procedural": {"exemplar": "quad.obj"}, "range": [-1, 1]})",
     ""},
    {Verdict::good,
     R"(object "displacement": {"procedural": {"exemplar": "quad.obj", "scale": 0.001, "offset": [-1000, 3.5],
        "seed": 2147483647, "triangle_size": 1000}, "amplitude": -1, "midlevel": 0})",
     ""},
    {Verdict::bad_beyond_schema, R"(object "displacement": {"procedural": {"exemplar": "a.png"}})", ""},
    {Verdict::bad, R"(object "displacement": {"procedural": {}})",
     "objects[0].displacement.procedural: the key 'exemplar' is missing"},
    {Verdict::bad, R"(object "displacement": {"procedural": "quad.obj"})",
     "objects[0].displacement.procedural: is a string, must be an object"},
    {Verdict::bad, R"(object "displacement": {"procedural": {"exemplar": "quad.obj"}, "map": "quad.obj"})",
     "objects[0].displacement.map: is for maps; leave out 'procedural' or 'map'"},
    {Verdict::bad, R"(object "displacement": {"procedural": {"exemplar": "quad.obj"}, "wrap": "clamp"})",
     "objects[0].displacement.wrap: is for maps; leave out 'procedural' or 'wrap'"},
    {Verdict::bad, R"(object "displacement": {"procedural": {"exemplar": "quad.obj", "scale": 0}})",
     "objects[0].displacement.procedural.scale: is 0, must be in [0.001, 1000]"},
    {Verdict::bad, R"(object "displacement": {"procedural": {"exemplar": "quad.obj", "offset": [0]}})",
     "objects[0].displacement.procedural.offset: has 1 items, must have 2"},
    {Verdict::bad, R"(object "displacement": {"procedural": {"exemplar": "quad.obj", "seed": -1}})",
     "objects[0].displacement.procedural.seed: is -1, must be in [0, 2147483647]"},
    {Verdict::bad, R"(object "displacement": {"procedural": {"exemplar": "quad.obj", "triangle_size": 1e4}})",
     "objects[0].displacement.procedural.triangle_size: is 10000, must be in [0.001, 1000]"},
    {Verdict::bad, R"(object "displacement": {"procedural": {"exemplar": "quad.obj", "seeds": 1}})",
     "objects[0].displacement.procedural.seeds: unknown key; did you mean 'seed'? (known: exemplar, scale, "
     "offset, "
     "seed, triangle_size)"},

    {Verdict::good, R"(object "material": {"albedo": [0, 0.5, 1], "roughness": 0.02, "specular": 0})", ""},
    {Verdict::bad, R"(object "material": {"albedo": [0, 0.5]})",
     "objects[0].material.albedo: has 2 items, must have 3"},
    {Verdict::bad, R"(object "material": {"albedo": [0, 0.5, 2]})",
     "objects[0].material.albedo[2]: is 2, must be in [0, 1]"},
    {Verdict::good, R"(object "material": {"albedo_map": "quad.obj"})", ""},
    {Verdict::bad, R"(object "material": {"albedo_map": [1, 1, 1]})",
     "objects[0].material.albedo_map: is an array, must be a string"},
    {Verdict::bad_beyond_schema, R"(object "material": {"albedo_map": "a.png"})", ""},
    {Verdict::bad, R"(object "material": {"colour_map": "a.png"})",
     "objects[0].material.colour_map: unknown key (known: albedo, albedo_map, roughness, "
     "specular)"},
    {Verdict::bad, R"(object "material": {"roughness": 0})",
     "objects[0].material.roughness: is 0, must be in [0.02, 1]"},

    {Verdict::good, R"(object "transform": {"translate": [1, 2, 3], "rotate_deg": [90, 0, -45], "scale": 2})",
     ""},
    {Verdict::good, R"(object "transform": {"scale": [1, -2, 0.5]})", ""},
    {Verdict::good, R"(object "transform": [1,0,0,5, 0,1,0,0, 0,0,1,0, 0,0,0,1])", ""},
    {Verdict::bad, R"(object "transform": [1, 0, 0])", "objects[0].transform: has 3 items, must have 16"},
    {Verdict::bad, R"(object "transform": {"rotate": [1, 0, 0]})", ""},
    {Verdict::bad, R"(object "transform": 3)", "objects[0].transform: is a number, must be an object"},
    {Verdict::bad_beyond_schema, R"(object "transform": [1,0,0,5, 0,1,0,0, 0,0,1,0, 0,0,1,1])",
     "objects[0].transform: the last row must be 0, 0, 0, 1"},
    {Verdict::bad_beyond_schema, R"(object "transform": {"scale": 0})",
     "objects[0].transform: flattens the object; it cannot be inverted"},

    {Verdict::good,
     R"("camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "fov_deg": 179.9})", ""},
    {Verdict::good, R"("camera": {})", ""},
    {Verdict::bad, R"("camera": {"fov_deg": 180})", "camera.fov_deg: is 180, must be in (0, 180)"},
    {Verdict::bad, R"("camera": {"fov_deg": 0})", "camera.fov_deg: is 0, must be in (0, 180)"},
    {Verdict::bad, R"("camera": {"eye": [1, 2, "3"]})", "camera.eye[2]: is a string, must be a number"},
    {Verdict::bad_beyond_schema, R"("camera": {"eye": [1, 2, 3], "look_at": [1, 2, 3]})",
     "camera: eye and look_at are the same point"},
    {Verdict::bad_beyond_schema, R"("camera": {"eye": [0, 5, 0], "look_at": [0, 0, 0], "up": [0, 2, 0]})",
     "camera.up: points along the view, must point across it"},

    {Verdict::good, R"("image": {"width": 1, "height": 16384, "spp": 1})", ""},
    {Verdict::bad, R"("image": {"width": 16385})", "image.width: is 16385, must be in [1, 16384]"},
    {Verdict::bad, R"("image": {"spp": -1})", "image.spp: is -1, must be in [1, 1048576]"},
    {Verdict::bad, R"("image": {"hight": 3})",
     "image.hight: unknown key; did you mean 'height'? (known: width, height, "
     "spp)"},

    {Verdict::good, R"("lights": [])", ""},
    {Verdict::good,
     R"("lights": [{"type": "sun", "direction": [0, -1, 0], "color": [1, 1, 1], "intensity": 2, "angle_deg": 3}])",
     ""},
    {Verdict::good, R"("lights": [{"type": "point", "position": [0, 1, 0], "intensity": 0, "radius": 0.1}])",
     ""},
    {Verdict::bad, R"("lights": [{}])", "lights[0]: the key 'type' is missing"},
    {Verdict::bad, R"("lights": [{"type": "spot"}])", "lights[0].type: is 'spot', must be 'sun' or 'point'"},
    {Verdict::bad, R"("lights": [{"type": "point"}])", "lights[0]: the key 'position' is missing"},
    {Verdict::bad, R"("lights": [{"type": "sun", "radius": 1}])",
     "lights[0].radius: unknown key (known: type, direction, color, intensity, angle_deg)"},
    {Verdict::bad, R"("lights": [{"type": "sun", "intensity": -1}])",
     "lights[0].intensity: is -1, must be in [0, 1e+09]"},
    {Verdict::bad_beyond_schema, R"("lights": [{"type": "sun", "direction": [0, 0, 0]}])",
     "lights[0].direction: has no length"},

    {Verdict::good,
     R"("environment": {"zenith": [0, 0, 9], "horizon": [1, 1, 1], "ground": [0, 0, 0], "up": [1, 0, -3], "intensity": 0})",
     ""},
    {Verdict::bad, R"("environment": {"sky": [0, 0, 1]})", ""},
    {Verdict::bad_beyond_schema, R"("environment": {"up": [0, 0, 0]})", "environment.up: has no length"},
    {Verdict::bad, R"("environment": {"up": "y"})", "environment.up: is a string, must be an array"},
    {Verdict::bad, R"("environment": {"zenith": 1})", "environment.zenith: is a number, must be an array"},

    {Verdict::good, R"("method": {"name": "pdm", "dt": 0.001, "jitter": true})", ""},
    {Verdict::bad, R"("method": "pdm")", "method: is a string, must be an object"},
    {Verdict::bad, R"("method": {"name": 3})", "method.name: is a number, must be a string"},
    {Verdict::good, R"("method": {"name": "dbvh", "leaf": "triangles"})", ""},  // the registry knows the words
    {Verdict::bad, R"("method": {"dt": ""})", "method.dt: is an empty string"},
    {Verdict::bad, R"("method": {"dt": [1]})", "method.dt: is an array, must be a number"},
};

}  // namespace relievo
