// Baking procedural heights into a map, so that they can be sculpted.
#pragma once

#include <optional>

#include "brushes/advance.h"
#include "brushes/height_map.h"
#include "editor/session/journal.h"
#include "renderer/procedural/procedural_source.h"
#include "renderer/scene/scene.h"

namespace relievo {

// A bake holds texture coordinates 0 to 1 and nothing beyond. Throws std::invalid_argument that says which leave that.
void check_bakeable(const SceneObject& object);

// Texels of the size at which a bake's texels are the source's own, at most HeightMap::kMaxSize: at an offset of whole
// texels the map then holds the very surface, rounded to counts.
ImageSize bake_size(const Procedural& settings, int exemplar_width, int exemplar_height);

// Heights at the texels' centres, rounded to counts. Throws std::invalid_argument on a size beyond
// [1, HeightMap::kMaxSize], Stopped where `advance` says so.
HeightMap bake(const ProceduralSource& source, const ImageSize& size, const Advance& advance = {});

// The displacement of an object whose heights were baked: the map's edge texels go on beyond it.
Displacement baked_displacement(const Displacement& procedural, const std::filesystem::path& map);

}  // namespace relievo
