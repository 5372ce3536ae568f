// Colour maps on disk: PNG and TIFF of 8 or 16 bits a channel; lossless, atomic, metadata and further
// channels kept.
#pragma once

#include <filesystem>
#include <memory>

#include "brushes/advance.h"
#include "brushes/colour_map.h"

namespace relievo {

// What the file held beside red, green and blue, for saving. Opaque to everyone but colour_file.cpp.
struct ColourOrigin;

struct LoadedColours {
    ColourMap map;
    std::shared_ptr<const ColourOrigin> origin;  // null: of a map that came from no file
};

// What a file's head says, without its texels.
struct ColourInfo {
    int width = 0, height = 0;  // texels
    int bits = 8, channels = 3;
};

// Throws as load_colours, but for what only the texels tell.
ColourInfo colour_info(const std::filesystem::path& path);

// The first three channels, taken as sRGB-encoded. Throws std::invalid_argument that names the file and says
// what was wrong: missing, cut off, another format or type of value, fewer than three channels, no texels,
// more than 16384 a side, several images.
LoadedColours load_colours(const std::filesystem::path& path);

// Throws std::invalid_argument unless the path's extension is .png, .tif or .tiff.
void check_colour_path(const std::filesystem::path& path);

// Saves atomically (atomic_file.h) in the format that the extension names and with the map's bits. Throws
// std::invalid_argument that names the path on any failure, Stopped where `advance` says so; the old file
// stays whole. With an origin of the same size, its further channels (alpha) are kept; of another format, only
// its general metadata is.
void save_colours(const ColourMap& map, const std::filesystem::path& path,
                  const ColourOrigin* origin = nullptr, const Advance& advance = {});

}  // namespace relievo
