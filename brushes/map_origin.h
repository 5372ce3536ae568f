// What load_map keeps of a file for save_map. Private to the two.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <vector>

#include "brushes/map_file.h"

namespace relievo {

struct MapOrigin {
    MapFormat format;
    MapRange range;
    OIIO::ImageSpec spec;  // of the file: channels, their formats, metadata

    // The file's pixels in its own formats, rows from the top; empty for a 16-bit file of one channel, whose
    // texels the map holds itself. 8-bit files are held widened to 16.
    std::vector<std::byte> pixels;

    // Of each channel, whether it repeats channel 0 everywhere (a grey image stored as RGB) and follows its
    // edits.
    std::vector<bool> repeats;
};

// The count that a float value becomes; saturates outside the range.
std::uint16_t count_of(double value, MapRange range);
// The value that stands for a count.
double value_of(std::uint16_t count, MapRange range);

bool is_float(MapFormat format);

}  // namespace relievo
