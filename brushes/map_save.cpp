// Saving displacement maps: encoded in memory by OpenImageIO, then written atomically.
#include <OpenImageIO/half.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

#include "brushes/atomic_file.h"
#include "brushes/image_write.h"
#include "brushes/map_origin.h"

namespace relievo {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail_map(const fs::path& path, const std::string& what) {
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

bool stamped(MapFormat format) {
    return format == MapFormat::tiff16 || is_float(format);
}

OIIO::ImageSpec spec_for(const HeightMap& map, MapFormat format, const MapOrigin* origin, bool same_layout) {
    OIIO::ImageSpec spec(map.width(), map.height(), 1, type_of(format));
    if (is_float(format)) spec.channelnames = {"Y"};
    if (same_layout) spec = origin->spec;
    if (!origin) {
        if (stamped(format)) stop_the_clock(spec);
        return spec;
    }
    keep_metadata(spec, origin->spec, origin->format == format);
    if (stamped(format)) stop_the_clock(spec);
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
              const MapOrigin* origin, const Advance& advance) {
    if (!(range.low < range.high)) fail_map(path, "the range's low must be below its high");
    const bool same_layout = origin && origin->format == format && origin->spec.width == map.width() &&
                             origin->spec.height == map.height();
    const OIIO::ImageSpec spec = spec_for(map, format, origin, same_layout);
    std::vector<std::byte> pixels = pixels_for(map, format, range, origin, spec, same_layout);
    if (same_layout) repeat_first_channel(pixels, spec, origin->repeats);
    const std::vector<unsigned char> file = encoded_image(path, "map", writer_name(format), spec, pixels, within(advance, 0, kEncoded));
    pixels = {};
    write_file_atomically(path, std::as_bytes(std::span(file)), within(advance, kEncoded, 1));
}

}  // namespace relievo
