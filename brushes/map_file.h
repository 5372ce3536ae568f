// Displacement maps on disk: 16-bit PNG and TIFF, EXR half and float; lossless, atomic, metadata kept.
#pragma once

#include <filesystem>
#include <memory>

#include "brushes/height_map.h"

namespace relievo {

// Values of counts 0 and 65535 in a float file: count = round((value - low) / (high - low) * 65535), clamped.
struct MapRange {
    double low = 0.0, high = 1.0;
};

enum class MapFormat { png16, tiff16, exr_half, exr_float };

// What the file held beside the texels, kept for saving: format, metadata, and of a float file the very
// values, so that a texel that no stroke changed is saved bit for bit. Opaque to everyone but map_file.cpp.
struct MapOrigin;

struct LoadedMap {
    HeightMap map;
    MapRange range;
    MapFormat format;
    std::shared_ptr<const MapOrigin> origin;
};

// Loads channel 0 of an image. Throws std::invalid_argument that names the file and says what was
// wrong: missing, cut off, no texels, larger than 16384 a side, NaN or infinity (with the texel).
// 8-bit images load with their values widened by 257 (and are saved as 16 bits).
LoadedMap load_map(const std::filesystem::path& path, MapRange range = {});

// The format that a path's extension names (.png, .tif, .tiff, .exr as float). std::invalid_argument
// otherwise.
MapFormat format_of(const std::filesystem::path& path);

// Saves atomically: temporary file beside `path`, fsync, rename, fsync of the folder. On any failure
// (unwritable, disk full) throws std::invalid_argument and the old file stays whole, the temporary one is
// removed.
void save_map(const HeightMap& map, const std::filesystem::path& path, MapFormat format, MapRange range = {},
              const MapOrigin* origin = nullptr);

}  // namespace relievo
