// What a session or a reference render reads: a scene whose method is known to the registry, and its maps.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "brushes/map_file.h"
#include "renderer/scene/scene.h"

namespace relievo {

// The scene with the method that was asked for (empty: its own) in place of its own, and `parameters` over
// its own. Checked here because not every session renders. Throws std::invalid_argument as load_scene and
// resolve_parameters do.
Scene open_scene(const std::filesystem::path& path, const std::string& method = {},
                 const std::map<std::string, double>& parameters = {});

// The map of one object: the file `path`, or (empty) the exemplar of procedural heights, or a new flat one that
// displaces nothing. `renderer`: one will hold it, too, by that method. Throws as load_map, and MemoryShortage before
// anything is loaded when memory would not do (memory_estimate.h).
LoadedMap open_map(const Displacement& displacement, const std::filesystem::path& path,
                   const MethodChoice* renderer = nullptr, const Advance& advance = {});

}  // namespace relievo
