// See colour_file.h.
#include "brushes/colour_file.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "brushes/atomic_file.h"
#include "brushes/image_read.h"
#include "brushes/image_write.h"

namespace relievo {
namespace fs = std::filesystem;

struct ColourOrigin {
    std::string format;             // OpenImageIO's name
    OIIO::ImageSpec spec;           // of the file: channels, their type, metadata
    std::vector<std::byte> pixels;  // rows from the top; empty where there are no further channels
};

namespace {

constexpr const char* kKind = "colour map";

int bits_of(const OIIO::ImageSpec& spec) {
    return spec.format == OIIO::TypeDesc::UINT8 ? 8 : 16;
}

void check_layout(const ImageName& name, const OIIO::ImageInput& image) {
    const OIIO::ImageSpec& spec = image.spec();
    const std::string format = image.format_name();
    const bool integer = spec.format == OIIO::TypeDesc::UINT8 || spec.format == OIIO::TypeDesc::UINT16;
    if ((format != "png" && format != "tiff") || !integer || !spec.channelformats.empty())
        name.fail("holds " + std::string(spec.format.c_str()) + " values in the format " + format +
                  "; a colour map is a PNG or TIFF of 8 or 16 bits");
    if (spec.nchannels < 3)
        name.fail("has " + std::to_string(spec.nchannels) + (spec.nchannels == 1 ? " channel" : " channels") +
                  "; a colour map has three (RGB) or four (RGBA)");
}

std::size_t texel_bytes(const OIIO::ImageSpec& spec) {
    return static_cast<std::size_t>(spec.nchannels) * spec.format.size();
}

std::uint16_t count_at(const std::byte* at, int bits) {
    if (bits == 8) return static_cast<std::uint16_t>(257 * std::to_integer<int>(*at));
    std::uint16_t count;
    std::memcpy(&count, at, sizeof count);
    return count;
}

void put_count(std::byte* at, int bits, std::uint16_t count) {
    if (bits == 8)
        *at = static_cast<std::byte>(count / 257);
    else
        std::memcpy(at, &count, sizeof count);
}

// visit(byte offset of a row's first texel in a channel of the pixels, channel, y), from the upper row on.
template <typename Visit>
void each_row(const OIIO::ImageSpec& spec, Visit visit) {
    const std::size_t row = static_cast<std::size_t>(spec.width) * texel_bytes(spec);
    for (int y = spec.height - 1; y >= 0; --y)
        for (std::size_t k = 0; k < 3; ++k)
            visit(static_cast<std::size_t>(spec.height - 1 - y) * row + k * spec.format.size(), k, y);
}

std::string writer_of(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (extension == ".png") return "png";
    if (extension == ".tif" || extension == ".tiff") return "tiff";
    throw std::invalid_argument("colour map '" + path.string() + "': the extension '" + extension +
                                "' is no format for colours; use .png, .tif or .tiff");
}

}  // namespace

ColourInfo colour_info(const fs::path& path) {
    const ImageName name{path, kKind};
    check_file(name);
    const auto image = open_image(name);
    check_layout(name, *image);
    const OIIO::ImageSpec& spec = image->spec();
    return {spec.width, spec.height, bits_of(spec), spec.nchannels};
}

LoadedColours load_colours(const fs::path& path) {
    const ImageName name{path, kKind};
    check_file(name);
    const PngCheck check = check_content(name);
    const auto image = open_image(name);
    check_layout(name, *image);
    auto origin = std::make_shared<ColourOrigin>();
    origin->format = image->format_name();
    origin->spec = image->spec();
    if (origin->format == "png" && !check.states_colour) origin->spec.erase_attribute("oiio:ColorSpace");
    const int bits = bits_of(origin->spec);
    std::vector<std::byte> pixels(origin->spec.image_pixels() * texel_bytes(origin->spec));
    read_pixels(name, *image, origin->spec.format, pixels.data());
    ColourMap map(origin->spec.width, origin->spec.height, bits);
    each_row(origin->spec, [&](std::size_t at, std::size_t channel, int y) {
        for (int x = 0; x < map.width(); ++x, at += texel_bytes(origin->spec))
            map.plane(channel).set(x, y, count_at(pixels.data() + at, bits));
    });
    if (origin->spec.nchannels > 3) origin->pixels = std::move(pixels);
    return {std::move(map), std::move(origin)};
}

void check_colour_path(const fs::path& path) {
    writer_of(path);
}

void save_colours(const ColourMap& map, const fs::path& path, const ColourOrigin* origin, const Advance& advance) {
    const std::string writer = writer_of(path);
    const bool same_size = origin && origin->spec.width == map.width() && origin->spec.height == map.height();
    OIIO::ImageSpec spec(map.width(), map.height(), 3,
                         map.bits() == 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16);
    if (same_size) spec = origin->spec;
    if (origin)
        keep_metadata(spec, origin->spec, origin->format == writer);
    else if (writer == "png")
        spec.attribute("oiio:ColorSpace", "sRGB");
    if (spec.nchannels > 3) spec.attribute("oiio:UnassociatedAlpha", 1);
    if (writer == "tiff") stop_the_clock(spec);
    std::vector<std::byte> pixels;
    if (same_size) pixels = origin->pixels;
    pixels.resize(spec.image_pixels() * texel_bytes(spec));
    constexpr double kPacked = 0.2;  // part of the time, about
    constexpr int kRows = 64;        // between two times that it is told
    each_row(spec, [&](std::size_t at, std::size_t channel, int y) {
        const int done = map.height() - 1 - y;
        if (channel == 0 && done % kRows == 0)
            tell(advance, kPacked * done / map.height(), not_written(path.string()));
        for (int x = 0; x < map.width(); ++x, at += texel_bytes(spec))
            put_count(pixels.data() + at, map.bits(), map.plane(channel).at(x, y));
    });
    const std::vector<unsigned char> file =
        encoded_image(path, kKind, writer.c_str(), spec, pixels, within(advance, kPacked, kEncoded));
    write_file_atomically(path, std::as_bytes(std::span(file)), within(advance, kEncoded, 1));
}

}  // namespace relievo
