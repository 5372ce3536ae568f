// Scene files for what a user drops on the window or asks for without having one: a bare mesh, another map
// for the edited object, a new map. They lie in the user's state folder, so that recent files, journals and
// recovery find them again; the same wish names the same file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "brushes/map_file.h"

namespace relievo {

// What a file is by its extension, in either case.
enum class FileKind { scene, mesh, map, unknown };
FileKind kind_of_file(const std::filesystem::path& path);

// Whether one of the functions below wrote that scene.
bool is_derived(const std::filesystem::path& scene);

// What a scene is called: its file's name, or of one that was written here "SCENE-MAP" or "MESH".
std::string scene_name(const std::filesystem::path& scene);

// A scene of the mesh with a new map. Throws std::invalid_argument as load_scene does when the mesh cannot be
// used.
std::filesystem::path scene_of_mesh(const std::filesystem::path& mesh);

// The scene with another map in the edited object's displacement, everything else as it is. Throws
// std::invalid_argument when either cannot be read.
std::filesystem::path scene_with_map(const std::filesystem::path& scene, const std::filesystem::path& map);

// The scene with these maps of the edited object: heights, and colours as the material's albedo map.
std::filesystem::path scene_with_maps(const std::filesystem::path& scene, const std::filesystem::path& map,
                                      const std::filesystem::path& colours);

struct NewMap {
    std::filesystem::path path;       // its extension must fit the format
    int width = 1024, height = 1024;  // texels, [1, HeightMap::kMaxSize]
    MapFormat format = MapFormat::png16;
};

// Writes a flat map at the midlevel of the scene's edited object, and the scene with it. Throws
// std::invalid_argument on a size out of range, an extension of another format, a map that does not fit into
// memory, an unwritable file, or where it would replace `open`, the map that is being edited.
std::filesystem::path scene_with_new_map(const std::filesystem::path& scene, const NewMap& map,
                                         const std::filesystem::path& open = {});

}  // namespace relievo
