// The keys of the scene file, and suggestions by edit distance (Levenshtein 1966).
#include "renderer/scene/scene_keys.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace relievo {

namespace {

constexpr std::string_view kTop[] = {"$schema", "relievo", "objects",     "camera",
                                     "image",   "lights",  "environment", "method"};
constexpr std::string_view kObject[] = {"name",     "mesh",        "normals",  "displacement",
                                        "material", "opacity_map", "transform"};
constexpr std::string_view kDisplacement[] = {"map",      "size",  "procedural", "amplitude",
                                              "midlevel", "range", "wrap"};
constexpr std::string_view kProcedural[] = {"exemplar", "scale", "offset", "seed", "triangle_size"};
constexpr std::string_view kMaterial[] = {"albedo", "albedo_map", "roughness", "specular"};
constexpr std::string_view kTransform[] = {"translate", "rotate_deg", "scale"};
constexpr std::string_view kCamera[] = {"eye", "look_at", "up", "fov_deg"};
constexpr std::string_view kImage[] = {"width", "height", "spp"};
constexpr std::string_view kSun[] = {"type", "direction", "color", "intensity", "angle_deg"};
constexpr std::string_view kPoint[] = {"type", "position", "color", "intensity", "radius"};
constexpr std::string_view kEnvironment[] = {"zenith", "horizon", "ground", "up", "intensity"};

constexpr SceneKeys kAll[] = {{"", kTop},
                              {"objects[]", kObject},
                              {"objects[].displacement", kDisplacement},
                              {"objects[].displacement.procedural", kProcedural},
                              {"objects[].material", kMaterial},
                              {"objects[].transform", kTransform},
                              {"camera", kCamera},
                              {"image", kImage},
                              {"lights[] sun", kSun},
                              {"lights[] point", kPoint},
                              {"environment", kEnvironment}};

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

}  // namespace

std::span<const SceneKeys> all_scene_keys() {
    return kAll;
}

std::span<const std::string_view> scene_keys(std::string_view where) {
    for (const SceneKeys& table : kAll) {
        if (table.where == where) return table.keys;
    }
    throw std::logic_error("no such part of a scene: " + std::string(where));
}

std::string unknown_key_message(std::string_view key, std::span<const std::string_view> known) {
    std::string list;
    std::string_view nearest;
    std::size_t least = std::max<std::size_t>(2, key.size() / 3) + 1;
    for (const std::string_view candidate : known) {
        list += (list.empty() ? "" : ", ") + std::string(candidate);
        const std::size_t distance = key.size() > 64 ? key.size() : edit_distance(key, candidate);
        if (distance < least) nearest = candidate, least = distance;
    }
    const std::string hint = nearest.empty() ? "" : "; did you mean '" + std::string(nearest) + "'?";
    return "unknown key" + hint + " (known: " + list + ")";
}

}  // namespace relievo
