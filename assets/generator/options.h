// The command line of relievo_assets.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace relievo::assets {

inline constexpr std::string_view kUsage =
    "relievo_assets -o FOLDER [--size N] [--only NAME] [--scenes FOLDER]\n"
    "Makes the sample meshes (FOLDER/meshes/*.obj), maps (FOLDER/maps/*.png, 16-bit), journals of strokes\n"
    "(FOLDER/strokes/*.jsonl) and images for the stamp (FOLDER/alphas/*.png, 16-bit).\n"
    "  -o FOLDER         where to; made if missing\n"
    "  --size N          texels a side of the maps, 64 to 8192 (1024); seams are exact from 256 on, at "
    "powers of two\n"
    "  --only NAME       one asset: plane, asteroid, chainmail, leather, orb, stump, knot, fur, scree,\n"
    "                    procedural_plane or procedural_sphere; no images\n"
    "  --scenes FOLDER   copy the scene files from there to FOLDER/scenes, so that the result can be "
    "opened\n";

struct Options {
    std::filesystem::path output;
    int size = 1024;
    std::string only;              // empty: all
    std::filesystem::path scenes;  // empty: none are copied
};

// Nothing for --help. Throws std::invalid_argument on an unknown option or a value that is missing or out of
// range.
std::optional<Options> parse_options(const std::vector<std::string>& arguments);

}  // namespace relievo::assets
