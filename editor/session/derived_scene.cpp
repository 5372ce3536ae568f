// See derived_scene.h.
#include "editor/session/derived_scene.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "brushes/atomic_file.h"
#include "brushes/colour_file.h"
#include "editor/session/memory_estimate.h"
#include "editor/session/session_mask.h"
#include "editor/session/text.h"
#include "editor/session/user_folders.h"
#include "renderer/scene/scene.h"

namespace relievo {
namespace fs = std::filesystem;

namespace {

using nlohmann::json;

fs::path derived_folder() {
    return state_folder() / "scenes";
}

// Files are told apart by what they say: NAME-<hash>.json.
fs::path write_scene(const json& scene, const std::string& name) {
    const fs::path folder = derived_folder();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw std::invalid_argument(folder.string() + ": cannot create the folder: " + error.message());
    const std::string text = scene.dump(2) + "\n";
    const fs::path path =
        folder / (name + "-" + formatted("%016zx", std::hash<std::string>{}(text)) + ".json");
    write_file_atomically(path, std::as_bytes(std::span(text)));
    return path;
}

void make_absolute(json& object, const char* key, const fs::path& folder) {
    if (object.contains(key))
        object[key] = (folder / object[key].get<std::string>()).lexically_normal().string();
}

// The scene's own text with absolute paths. It was loaded before: its shape is known to be right.
json movable(const Scene& scene) {
    json root = json::parse(std::ifstream(scene.path));
    const fs::path folder = scene.path.parent_path();
    root.erase("$schema");
    for (json& object : root["objects"]) {
        make_absolute(object, "mesh", folder);
        make_absolute(object, "opacity_map", folder);
        if (object.contains("material")) make_absolute(object["material"], "albedo_map", folder);
        if (!object.contains("displacement")) continue;
        json& displacement = object["displacement"];
        make_absolute(displacement, "map", folder);
        if (displacement.contains("procedural")) make_absolute(displacement["procedural"], "exemplar", folder);
    }
    return root;
}

// `colours` empty: as the scene says.
fs::path with_map(const Scene& scene, const fs::path& map, const fs::path& colours = {}) {
    json root = movable(scene);
    json& displacement = root["objects"][0]["displacement"];
    if (displacement.is_null()) displacement = json::object();  // a bare mesh's scene says nothing of it
    // A map that stands for procedural heights is a bake: it is clamped as that is.
    if (displacement.contains("procedural")) displacement["wrap"] = "clamp";
    for (const char* key : {"size", "procedural"}) displacement.erase(key);
    displacement["map"] = fs::absolute(map).lexically_normal().string();
    if (!colours.empty())
        root["objects"][0]["material"]["albedo_map"] = fs::absolute(colours).lexically_normal().string();
    std::string name = is_derived(scene.path) ? scene_name(scene.path) : scene.path.stem().string();
    const std::string before = "-" + scene.objects.front().displacement.map.stem().string(), now = map.stem().string();
    if (is_derived(scene.path) && name.ends_with(before)) name.resize(name.size() - before.size());
    return write_scene(root, name == now ? name : name + "-" + now);
}

bool fits(MapFormat named, MapFormat format) {
    return named == format || (named == MapFormat::exr_float && format == MapFormat::exr_half);
}

}  // namespace

FileKind kind_of_file(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    const auto among = [&](std::initializer_list<std::string_view> known) {
        return std::find(known.begin(), known.end(), extension) != known.end();
    };
    if (extension == ".json") return FileKind::scene;
    if (among({".obj", ".ply", ".off", ".stl"})) return FileKind::mesh;
    if (among({".png", ".tif", ".tiff", ".exr"})) return FileKind::map;
    return FileKind::unknown;
}

bool is_derived(const fs::path& scene) {
    std::error_code ignored;
    return fs::equivalent(fs::absolute(scene).parent_path(), derived_folder(), ignored);
}

std::string scene_name(const fs::path& scene) {
    if (!is_derived(scene)) return scene.filename().string();
    const std::string name = scene.stem().string();
    return name.substr(0, name.rfind('-'));  // the hash
}

fs::path scene_of_mesh(const fs::path& mesh) {
    const json scene{{"relievo", 1},
                     {"objects", {{{"mesh", fs::absolute(mesh).lexically_normal().string()}}}}};
    const fs::path path = write_scene(scene, mesh.stem().string());
    try {
        load_scene(path);
    } catch (...) {
        std::error_code ignored;
        fs::remove(path, ignored);
        throw;
    }
    return path;
}

fs::path scene_with_map(const fs::path& scene, const fs::path& map) {
    map_info(map);  // throws where it is no map
    return with_map(load_scene(scene), map);
}

fs::path scene_with_maps(const fs::path& scene, const fs::path& map, const fs::path& colours) {
    map_info(map);
    colour_info(colours);
    return with_map(load_scene(scene), map, colours);
}

fs::path scene_with_new_map(const fs::path& scene, const NewMap& map, const fs::path& open) {
    std::error_code ignored;
    if (!open.empty() && fs::equivalent(map.path, open, ignored))
        throw std::invalid_argument("map '" + map.path.string() +
                                    "': is the one that is open; give the new one another name");
    const Scene from = load_scene(scene);
    const Displacement& displacement = from.objects.front().displacement;
    if (!fits(format_of(map.path), map.format))
        throw std::invalid_argument("map '" + map.path.string() +
                                    "': the extension names another format than was asked for");
    const auto in_range = [](int side) { return side >= 1 && side <= HeightMap::kMaxSize; };
    if (!in_range(map.width) || !in_range(map.height))
        throw std::invalid_argument("map '" + map.path.string() + "': a side must be in [1, " +
                                    std::to_string(HeightMap::kMaxSize) + "] texels");
    const MapInfo info{map.width, map.height, 4, map.format};
    require_memory(map.path, info, estimate_memory(info, true, MapBounds::planes), available_memory());
    const auto flat = static_cast<std::uint16_t>(std::lround(displacement.midlevel * 65535));
    save_map(HeightMap(map.width, map.height, flat), map.path, map.format,
             {displacement.range_low, displacement.range_high});
    save_mask(nullptr, mask_path_beside(map.path));  // of a map that lay there before
    return with_map(from, map.path);
}

}  // namespace relievo
