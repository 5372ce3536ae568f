// Opening and reading image files through OpenImageIO, with the checks that it leaves out. Private to
// loading.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "brushes/file_check.h"

namespace relievo {

// A file, and what messages call it: "map 'a.png': no such file".
struct ImageName {
    std::filesystem::path path;
    const char* kind;
    [[noreturn]] void fail(const std::string& what) const;  // std::invalid_argument
};

void check_file(const ImageName& name);         // that it exists and is a file
PngCheck check_content(const ImageName& name);  // for damage
// With 1 to 16384 texels a side, flat; colours not multiplied by alpha.
std::unique_ptr<OIIO::ImageInput> open_image(const ImageName& name);
// All channels of the file's one image, rows from the top. `type`: UNKNOWN for the file's own.
void read_pixels(const ImageName& name, OIIO::ImageInput& image, OIIO::TypeDesc type, std::byte* pixels);

}  // namespace relievo
