// Displacement maps on disk: 16-bit PNG and TIFF, EXR half and float; lossless, atomic, metadata kept.
#pragma once

#include <filesystem>
#include <memory>

#include "brushes/advance.h"
#include "brushes/height_map.h"

namespace relievo {

// The values that counts 0 and 65535 stand for in an EXR: count = round((value - low) / (high - low) *
// 65535), held to [0, 65535]. PNG and TIFF hold the counts themselves and ignore it.
struct MapRange {
    double low = 0.0, high = 1.0;
};

// exr_half cannot hold all 65,536 counts (of [0, 1] it tells 15,361 values apart): use it for maps that came
// as half.
enum class MapFormat { png16, tiff16, exr_half, exr_float };

// What the file held beside the texels, for saving: metadata, other channels, and of a float file the very
// values. Opaque to everyone but map_load.cpp and map_save.cpp.
struct MapOrigin;

struct LoadedMap {
    HeightMap map;
    MapRange range;
    MapFormat format;
    std::shared_ptr<const MapOrigin> origin;
};

// What a file's head says, without its texels.
struct MapInfo {
    int width = 0, height = 0;  // texels
    int bytes_per_texel = 0;    // of all channels, as loading holds them: 8-bit channels widened to 16
    MapFormat format = MapFormat::png16;
};

// Throws as load_map, but for what only the texels tell.
MapInfo map_info(const std::filesystem::path& path);

// Loads channel 0 of a PNG or TIFF of 8 or 16 bits or an EXR whose channel 0 is half or float. 8-bit values
// are widened by 257 (and saved as 16 bits). Throws std::invalid_argument that names the file and says what
// was wrong: missing, cut off, another format, no texels, more than 16384 a side, several images, NaN or
// infinity (with the texel). Stopped where `advance` says so.
LoadedMap load_map(const std::filesystem::path& path, MapRange range = {}, const Advance& advance = {});

// The format that a path's extension names (.png, .tif, .tiff, .exr as float). std::invalid_argument
// otherwise.
MapFormat format_of(const std::filesystem::path& path);

// Saves atomically (see atomic_file.h). On any failure, such as a full disk or an unwritable folder, throws
// std::invalid_argument that names the path; the old file stays whole. So it does where `advance` stops it.
//
// With the origin of the same format and size, its layout, compression (if lossless), metadata and other
// channels are kept; channels that repeated channel 0 (grey stored as RGB) go on doing so. With one of
// another format, its general metadata is kept. Where both are float and `range` is the one it was loaded
// with, a texel that still has the count that it was loaded with is saved with the value that it was loaded
// with, bit for bit; any other as low + (high - low) * count / 65535.
void save_map(const HeightMap& map, const std::filesystem::path& path, MapFormat format, MapRange range = {},
              const MapOrigin* origin = nullptr, const Advance& advance = {});

}  // namespace relievo
