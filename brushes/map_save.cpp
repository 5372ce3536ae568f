// Saving displacement maps: encoded in memory by OpenImageIO, then written atomically.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/half.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>

#include "brushes/atomic_file.h"
#include "brushes/map_origin.h"

namespace relievo {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
    throw std::invalid_argument("cannot write map '" + path.string() + "': " + what);
}

const char* writer_name(MapFormat format) {
    switch (format) {
        case MapFormat::png16:
            return "png";
        case MapFormat::tiff16:
            return "tiff";
        case MapFormat::exr_half:
        case MapFormat::exr_float:
            break;
    }
    return "openexr";
}

OIIO::TypeDesc type_of(MapFormat format) {
    if (!is_float(format)) return OIIO::TypeDesc::UINT16;
    return format == MapFormat::exr_half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT;
}

// Metadata that describes how the old file was encoded, not what it shows.
bool is_encoding(std::string_view name) {
    constexpr std::array kNames{"oiio:BitsPerSample", "tiff:PhotometricInterpretation",
                                "tiff:ColorSpace",    "tiff:bitspersample",
                                "jpeg:subsampling",   "oiio:subimages"};
    return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

// Belongs to one file format or to its colour channels; means nothing, or something else, in another.
bool is_format_bound(std::string_view name) {
    constexpr std::array<std::string_view, 7> kPrefixes{
        "ICCProfile", "png:", "tiff:", "openexr:", "compression", "planarconfig", "oiio:"};
    return std::any_of(kPrefixes.begin(), kPrefixes.end(),
                       [&](std::string_view p) { return name.starts_with(p); });
}

void make_lossless(OIIO::ImageSpec& spec) {
    constexpr std::array<std::string_view, 7> kLossy{"jpeg", "b44",   "b44a",    "dwaa",
                                                     "dwab", "pxr24", "ccittrle"};
    const std::string compression = spec.get_string_attribute("compression");
    const std::string_view kind = std::string_view(compression).substr(0, compression.find(':'));
    if (std::find(kLossy.begin(), kLossy.end(), kind) != kLossy.end()) spec.attribute("compression", "zip");
}

// The writers of TIFF and EXR stamp the hour on a file that has no date, and the same map would give other bytes
// every second. This is EXIF's way of writing that the date is not known.
void stop_the_clock(OIIO::ImageSpec& spec, MapFormat format) {
    const bool stamped = format == MapFormat::tiff16 || is_float(format);
    if (stamped && !spec.find_attribute("DateTime")) spec.attribute("DateTime", "    :  :     :  :  ");
}

OIIO::ImageSpec spec_for(const HeightMap& map, MapFormat format, const MapOrigin* origin, bool same_layout) {
    OIIO::ImageSpec spec(map.width(), map.height(), 1, type_of(format));
    if (is_float(format)) spec.channelnames = {"Y"};
    if (same_layout) spec = origin->spec;
    if (!origin) {
        stop_the_clock(spec, format);
        return spec;
    }
    spec.extra_attribs.clear();
    for (const OIIO::ParamValue& attribute : origin->spec.extra_attribs) {
        const std::string_view name(attribute.name().data(), attribute.name().size());
        if (is_encoding(name) || (origin->format != format && is_format_bound(name))) continue;
        spec.extra_attribs.push_back(attribute);
    }
    make_lossless(spec);
    stop_the_clock(spec, format);
    return spec;
}

template <typename Value>
void put(std::byte* at, Value value) {
    std::memcpy(at, &value, sizeof value);
}

void put_count(std::byte* at, MapFormat format, std::uint16_t count, MapRange range) {
    if (format == MapFormat::exr_half) return put(at, half(static_cast<float>(value_of(count, range))));
    if (format == MapFormat::exr_float) return put(at, static_cast<float>(value_of(count, range)));
    put(at, count);
}

// The first channel's value in a float file, whatever its precision.
float origin_value(const MapOrigin& origin, std::size_t offset) {
    if (origin.format == MapFormat::exr_half) {
        half value;
        std::memcpy(&value, origin.pixels.data() + offset, sizeof value);
        return static_cast<float>(value);
    }
    float value;
    std::memcpy(&value, origin.pixels.data() + offset, sizeof value);
    return value;
}

// The file's pixels: the origin's where it has the same layout, with channel 0 and its repetitions taken from
// the map; of a float origin, the very values of texels whose count is still the one that they became.
std::vector<std::byte> pixels_for(const HeightMap& map, MapFormat format, MapRange range,
                                  const MapOrigin* origin, const OIIO::ImageSpec& spec, bool same_layout) {
    const bool exact = origin && is_float(origin->format) && is_float(format) && !origin->pixels.empty() &&
                       origin->spec.width == map.width() && origin->spec.height == map.height() &&
                       origin->range.low == range.low && origin->range.high == range.high;
    const std::size_t bytes = spec.pixel_bytes(true), old_bytes = exact ? origin->spec.pixel_bytes(true) : 0;
    std::vector<std::byte> pixels;
    if (same_layout && !origin->pixels.empty()) pixels = origin->pixels;
    pixels.resize(spec.image_pixels() * bytes);

    std::size_t pixel = 0;
    for (int y = map.height() - 1; y >= 0; --y)
        for (int x = 0; x < map.width(); ++x, ++pixel) {
            std::byte* const at = pixels.data() + pixel * bytes;
            const std::uint16_t count = map.at(x, y);
            if (exact) {
                const float old = origin_value(*origin, pixel * old_bytes);
                if (count_of(double{old}, range) == count) {
                    if (format == MapFormat::exr_half)
                        put(at, half(old));
                    else
                        put(at, old);
                    continue;
                }
            }
            put_count(at, format, count, range);
        }
    return pixels;
}

void repeat_first_channel(std::vector<std::byte>& pixels, const OIIO::ImageSpec& spec,
                          const std::vector<bool>& repeats) {
    const std::size_t bytes = spec.pixel_bytes(true), size = spec.channelformat(0).size();
    std::size_t offset = 0;
    for (int channel = 0; channel < spec.nchannels; offset += spec.channelformat(channel).size(), ++channel) {
        if (channel == 0 || !repeats[static_cast<std::size_t>(channel)]) continue;
        for (std::size_t at = 0; at < pixels.size(); at += bytes)
            std::memcpy(pixels.data() + at + offset, pixels.data() + at, size);
    }
}

std::vector<unsigned char> encoded(const fs::path& path, MapFormat format, const OIIO::ImageSpec& spec,
                                   const std::vector<std::byte>& pixels) {
    std::vector<unsigned char> file;
    OIIO::Filesystem::IOVecOutput memory(file);
    const auto writer = OIIO::ImageOutput::create(writer_name(format));
    if (!writer) fail(path, "OpenImageIO was built without " + std::string(writer_name(format)));
    writer->set_ioproxy(&memory);
    const OIIO::TypeDesc type =
        spec.channelformats.empty() ? spec.format : OIIO::TypeDesc(OIIO::TypeDesc::UNKNOWN);
    // The name only serves the writer's messages: the bytes go to memory.
    if (!writer->open(path.filename().string(), spec) || !writer->write_image(type, pixels.data()) ||
        !writer->close())
        fail(path, writer->geterror());
    return file;
}

}  // namespace

MapFormat format_of(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (extension == ".png") return MapFormat::png16;
    if (extension == ".tif" || extension == ".tiff") return MapFormat::tiff16;
    if (extension == ".exr") return MapFormat::exr_float;
    throw std::invalid_argument("map '" + path.string() + "': the extension '" + extension +
                                "' is no map format; use .png, .tif, .tiff or .exr");
}

void save_map(const HeightMap& map, const fs::path& path, MapFormat format, MapRange range,
              const MapOrigin* origin) {
    if (!(range.low < range.high)) fail(path, "the range's low must be below its high");
    const bool same_layout = origin && origin->format == format && origin->spec.width == map.width() &&
                             origin->spec.height == map.height();
    const OIIO::ImageSpec spec = spec_for(map, format, origin, same_layout);
    std::vector<std::byte> pixels = pixels_for(map, format, range, origin, spec, same_layout);
    if (same_layout) repeat_first_channel(pixels, spec, origin->repeats);
    const std::vector<unsigned char> file = encoded(path, format, spec, pixels);
    pixels = {};
    write_file_atomically(path, std::as_bytes(std::span(file)));
}

}  // namespace relievo
