// The camera of a scene file: what the file says, and a framing of the objects for what it leaves open.
#pragma once

#include "renderer/scene/json_reader.h"
#include "renderer/scene/scene.h"

namespace relievo {

// `scene` has its objects, origin and image size. std::invalid_argument with the JSON path on bad values.
Camera read_camera(const JsonNode& node, const Scene& scene);

}  // namespace relievo
