// The values that a session's `set` command changes, by the key that journals store.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "editor/session/journal.h"
#include "renderer/scene/scene.h"

namespace relievo {

// Which part of the renderer has to hear of a change.
enum class SettingScope { camera, lights, material, displacement, heights, method };

// Keys, with S a number and V an array of three:
//   procedural.exemplar "file" (relative to the scene's folder), procedural.scale S, procedural.offset [u, v],
//   procedural.seed S, procedural.triangle_size S (where the heights are procedural; ranges as in the scene file),
//   amplitude S (world units), midlevel S [0, 1], method "name", method.PARAMETER S (the registry's range),
//   camera [eye V, look_at V, up V, fov_deg] as ten numbers (world space),
//   material.albedo V, material.roughness S, material.specular S (of the edited object),
//   lights[I].direction V, .position V, .color V, .intensity S, .angle_deg S, .radius S,
//   environment.zenith V, .horizon V, .ground V, .up V, .intensity S,
//   lights [environment.up V, then of every light its direction V where it is a sun, else its position V].
// Changes `scene` (objects[0] for what belongs to an object) and says what changed. Throws
// std::invalid_argument `set KEY: ...` on an unknown key, a wrong type or a value out of range, and then
// changes nothing.
// Where the scope is heights, nothing is changed but `heights`, which becomes what objects[0] asks for: its exemplar may
// have to be read first.
SettingScope apply_setting(Scene& scene, const std::string& key, const SetValue& value, Displacement& heights);

// The value of key `camera`.
SetValue camera_value(const Camera& camera);

// The value of key `lights`.
SetValue lights_value(const std::vector<Light>& lights, const glm::dvec3& sky_up);

}  // namespace relievo
