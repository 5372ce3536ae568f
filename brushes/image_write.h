// Encoding image files in memory through OpenImageIO, and what of an old file's head a new one keeps. Private
// to saving maps and pictures.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "brushes/advance.h"

namespace relievo {

// Puts the metadata of `origin` into `spec`, but for what describes how the old file was encoded; where
// `same_format` is false, also but for what belongs to one file format. A lossy compression becomes a
// lossless one.
void keep_metadata(OIIO::ImageSpec& spec, const OIIO::ImageSpec& origin, bool same_format);

// The writers of TIFF and EXR stamp the hour on a file that has no date, and the same map would give other
// bytes every second. This is EXIF's way of writing that the date is not known.
void stop_the_clock(OIIO::ImageSpec& spec);

// Of the time that an image takes to be saved, about; the rest is the disk's.
constexpr double kEncoded = 0.9;

// The file's bytes. `writer`: OpenImageIO's name of the format; `pixels`: in the spec's own types, rows from
// the top. Throws std::invalid_argument that says "cannot write KIND 'PATH'"; Stopped where `advance` says so.
std::vector<unsigned char> encoded_image(const std::filesystem::path& path, const char* kind,
                                         const char* writer, const OIIO::ImageSpec& spec,
                                         std::span<const std::byte> pixels, const Advance& advance = {});

}  // namespace relievo
