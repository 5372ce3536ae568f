// Finds damage in PNG files before libpng does, which prints to the terminal by itself. Private to loading.
#pragma once

#include <filesystem>
#include <string>

namespace relievo {

// What is wrong with a PNG (a chunk cut off, or with a wrong checksum) in a few words; empty for a whole file
// and for every other format.
std::string png_damage(const std::filesystem::path& path);

}  // namespace relievo
