// Pictures on disk: 8-bit PNG for people, float EXR with named layers for programs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "brushes/advance.h"

namespace relievo {

struct DisplayPicture {  // sRGB-encoded, row 0 at the top
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;  // 4 a pixel
};

// Columns [x0, x1) of a picture of the same size take the place of its own.
void put_columns(DisplayPicture& picture, const std::vector<std::uint8_t>& rgba, int x0, int x1);

struct FloatPicture {  // row 0 at the top
    int width = 0, height = 0;
    std::vector<std::string> channels;
    std::vector<float> values;  // channels.size() a pixel
};

// These write atomically (brushes/atomic_file.h). Throw std::invalid_argument that names the path
// when it cannot be written, Stopped where `advance` says so; an older file then stays whole.
void write_png(const std::filesystem::path& path, const DisplayPicture& picture, const Advance& advance = {});
void write_exr(const std::filesystem::path& path, const FloatPicture& picture, const Advance& advance = {});
void write_jpeg(const std::filesystem::path& path, const DisplayPicture& picture);  // without alpha

// Any 8-bit picture with 3 or 4 channels. Throws std::invalid_argument that names the file.
DisplayPicture read_display_picture(const std::filesystem::path& path);

// Throws std::invalid_argument when nothing can be written at `path`: to be told before a long render, not
// after.
void check_writable(const std::filesystem::path& path);

struct PictureDifference {
    double rmse = 0;     // of the RGB values, [0, 1]
    double largest = 0;  // of one channel, [0, 1]
    int worst_x = 0, worst_y = 0;
};
// Throws std::invalid_argument when the sizes differ.
PictureDifference compare_pictures(const DisplayPicture& a, const DisplayPicture& b);

}  // namespace relievo
