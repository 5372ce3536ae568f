// See image_read.h.
#include "brushes/image_read.h"

#include <stdexcept>
#include <string_view>
#include <system_error>

#include "brushes/height_map.h"

namespace relievo {
namespace fs = std::filesystem;
namespace {

// The first line of what the library says, without the file name that it likes to repeat.
std::string library_error(std::string text) {
    text = text.substr(0, text.find('\n'));
    return text.empty() ? "not a readable image" : text;
}

void check_spec(const ImageName& name, OIIO::ImageInput& image) {
    const OIIO::ImageSpec& spec = image.spec();
    const auto limit = std::to_string(HeightMap::kMaxSize);
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) name.fail("the image has no texels");
    if (spec.width > HeightMap::kMaxSize || spec.height > HeightMap::kMaxSize)
        name.fail(std::to_string(spec.width) + " x " + std::to_string(spec.height) + " texels; at most " +
                  limit + " a side are possible");
    if (spec.deep || spec.depth > 1) name.fail("deep or volume images cannot be maps");
}

// Reads every row of a TIFF by itself: by whole images, the library passes strips whose checksum is wrong.
bool read_rows(OIIO::ImageInput& image, OIIO::TypeDesc type, std::byte* pixels) {
    const OIIO::ImageSpec spec = image.spec();
    const std::size_t row_bytes = static_cast<std::size_t>(spec.width * spec.nchannels) * type.size();
    for (int y = 0; y < spec.height; ++y, pixels += row_bytes)
        if (!image.read_scanline(spec.y + y, 0, type, pixels)) return false;
    return true;
}

}  // namespace

void ImageName::fail(const std::string& what) const {
    throw std::invalid_argument(std::string(kind) + " '" + path.string() + "': " + what);
}

void check_file(const ImageName& name) {
    std::error_code error;
    if (!fs::exists(name.path, error)) name.fail("no such file");
    if (!fs::is_regular_file(name.path, error)) name.fail("not a file");
}

PngCheck check_content(const ImageName& name) {
    const PngCheck check = check_png(name.path);
    if (!check.damage.empty()) name.fail("cut off or damaged: " + check.damage);
    return check;
}

std::unique_ptr<OIIO::ImageInput> open_image(const ImageName& name) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);  // or colours come multiplied by alpha, and lose bits
    auto image = OIIO::ImageInput::open(name.path.string(), &config);
    if (!image) name.fail("cannot be opened as an image: " + library_error(OIIO::geterror()));
    check_spec(name, *image);
    return image;
}

void read_pixels(const ImageName& name, OIIO::ImageInput& image, OIIO::TypeDesc type, std::byte* pixels) {
    const OIIO::ImageSpec spec = image.spec();
    const bool by_rows = std::string_view(image.format_name()) == "tiff" && spec.tile_width == 0;
    const bool read =
        by_rows ? read_rows(image, type, pixels) : image.read_image(0, 0, 0, spec.nchannels, type, pixels);
    // The library can also note an error and go on with zeros.
    if (!read || image.has_error()) name.fail("cut off or damaged: " + library_error(image.geterror()));
    if (image.seek_subimage(1, 0) || image.seek_subimage(0, 1))
        name.fail("holds several images or levels; a map is a file with one");
}

}  // namespace relievo
