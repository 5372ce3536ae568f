// What OpenImageIO does not tell of a PNG: damage (libpng prints to the terminal by itself, so this looks
// first) and whether the file states its colour space. Private to loading.
#pragma once

#include <filesystem>
#include <string>

namespace relievo {

struct PngCheck {
    std::string damage;  // a chunk cut off or with a wrong checksum, in a few words; empty for a whole file
    bool states_colour =
        false;  // has a chunk about colour space or gamma (OpenImageIO makes one up where it has not)
};

// Finds nothing in files of other formats.
PngCheck check_png(const std::filesystem::path& path);

}  // namespace relievo
