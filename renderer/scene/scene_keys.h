// Every key that a scene file may hold, in one place: the loader refuses others, assets/scene.schema.json
// lists the same (a test compares them).
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace relievo {

struct SceneKeys {
    std::string_view where;  // the object's path, for example "objects[].displacement"
    std::span<const std::string_view> keys;
};

std::span<const SceneKeys> all_scene_keys();
// Requires a path of all_scene_keys().
std::span<const std::string_view> scene_keys(std::string_view where);

// What to say of a key that is not among `known`: the nearest one, when it is near, and the list.
std::string unknown_key_message(std::string_view key, std::span<const std::string_view> known);

}  // namespace relievo
