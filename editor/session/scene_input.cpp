// See scene_input.h.
#include "editor/session/scene_input.h"

#include <cmath>
#include <stdexcept>

#include "editor/session/memory_estimate.h"
#include "renderer/methods/registry.h"

namespace relievo {

Scene open_scene(const std::filesystem::path& path, const std::string& method,
                 const std::map<std::string, double>& parameters) {
    Scene scene = load_scene(path);
    try {
        const Method& of_scene = find_method(scene.method.name);
        for (const auto& [name, word] : scene.method.words)
            scene.method.parameters[name] = parameter_word(of_scene, name, word);
        scene.method.words.clear();
        resolve_parameters(of_scene, scene.method.parameters);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(path.string() + ": method: " + error.what());
    }
    if (!method.empty() && method != scene.method.name) scene.method = {method, {}};
    for (const auto& [name, value] : parameters) scene.method.parameters[name] = value;
    resolve_parameters(find_method(scene.method.name), scene.method.parameters);
    return scene;
}

LoadedMap open_map(const Displacement& displacement, const std::filesystem::path& path,
                   const MethodChoice* renderer, const Advance& advance) {
    const std::filesystem::path& file =
        path.empty() && displacement.procedural ? displacement.procedural->exemplar : path;
    const MapRange range{displacement.range_low, displacement.range_high};
    const MapInfo fresh{displacement.map_size, displacement.map_size, sizeof(std::uint16_t), MapFormat::tiff16};
    const MapInfo info = file.empty() ? fresh : map_info(file);
    const MapBounds bounds = renderer != nullptr ? find_method(renderer->name).map_bounds : MapBounds::none;
    require_memory(file.empty() ? "new map" : file, info, estimate_memory(info, renderer != nullptr, bounds),
                   available_memory());
    if (!file.empty()) return load_map(file, range, advance);
    const auto flat = static_cast<std::uint16_t>(std::lround(displacement.midlevel * 65535));
    return {HeightMap(displacement.map_size, displacement.map_size, flat), range, MapFormat::tiff16, nullptr};
}

}  // namespace relievo
