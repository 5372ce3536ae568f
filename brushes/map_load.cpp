// Loading displacement maps through OpenImageIO.
#include <OpenImageIO/half.h>

#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>

#include "brushes/image_read.h"
#include "brushes/map_origin.h"

namespace relievo {
namespace fs = std::filesystem;
namespace {

ImageName map_name(const fs::path& path) {
    return {path, "map"};
}

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
    map_name(path).fail(what);
}

MapFormat format_in(const fs::path& path, const OIIO::ImageInput& image) {
    const std::string name = image.format_name();
    const OIIO::TypeDesc type = image.spec().channelformat(0);
    const bool integer = type == OIIO::TypeDesc::UINT8 || type == OIIO::TypeDesc::UINT16;
    if (name == "png" && integer) return MapFormat::png16;
    if (name == "tiff" && integer) return MapFormat::tiff16;
    if (name == "openexr" && type == OIIO::TypeDesc::HALF) return MapFormat::exr_half;
    if (name == "openexr" && type == OIIO::TypeDesc::FLOAT) return MapFormat::exr_float;
    fail(path, "holds " + std::string(type.c_str()) + " values in the format " + name +
                   "; a map is a 16-bit PNG or TIFF (8-bit works) or an EXR of half or float");
}

template <typename Value>
Value value_at(const std::vector<std::byte>& pixels, std::size_t offset) {
    Value value;
    std::memcpy(&value, pixels.data() + offset, sizeof value);
    return value;
}

std::vector<bool> find_repeats(const MapOrigin& origin, std::size_t pixel_bytes) {
    const OIIO::ImageSpec& spec = origin.spec;
    const std::size_t size = spec.channelformat(0).size();
    std::vector<bool> repeats(static_cast<std::size_t>(spec.nchannels), true);
    std::size_t offset = 0;
    for (int channel = 0; channel < spec.nchannels; offset += spec.channelformat(channel).size(), ++channel) {
        bool same = channel != spec.alpha_channel && spec.channelformat(channel) == spec.channelformat(0);
        for (std::size_t at = 0; same && at < origin.pixels.size(); at += pixel_bytes)
            same = std::memcmp(origin.pixels.data() + at, origin.pixels.data() + at + offset, size) == 0;
        repeats[static_cast<std::size_t>(channel)] = same;
    }
    return repeats;
}

double checked_value(const fs::path& path, const MapOrigin& origin, std::size_t offset, int x, int y) {
    const double value = origin.format == MapFormat::exr_half
                             ? double{static_cast<float>(value_at<half>(origin.pixels, offset))}
                             : double{value_at<float>(origin.pixels, offset)};
    if (std::isfinite(value)) return value;
    fail(path, std::string(std::isnan(value) ? "NaN" : "infinity") + " at texel (" + std::to_string(x) +
                   ", " + std::to_string(y) + "), counted from the lower left; every height must be finite");
}

HeightMap counts_of(const fs::path& path, const MapOrigin& origin, std::size_t pixel_bytes) {
    HeightMap map(origin.spec.width, origin.spec.height);
    std::size_t offset = 0;
    for (int y = map.height() - 1; y >= 0; --y)
        for (int x = 0; x < map.width(); ++x, offset += pixel_bytes)
            map.set(x, y,
                    is_float(origin.format)
                        ? count_of(checked_value(path, origin, offset, x, y), origin.range)
                        : value_at<std::uint16_t>(origin.pixels, offset));
    return map;
}

}  // namespace

std::uint16_t count_of(double value, MapRange range) {
    const double count = std::round((value - range.low) / (range.high - range.low) * 65535.0);
    return static_cast<std::uint16_t>(std::min(std::max(count, 0.0), 65535.0));
}

double value_of(std::uint16_t count, MapRange range) {
    return range.low + (range.high - range.low) * count / 65535.0;
}

bool is_float(MapFormat format) {
    return format == MapFormat::exr_half || format == MapFormat::exr_float;
}

MapInfo map_info(const fs::path& path) {
    check_file(map_name(path));
    const auto image = open_image(map_name(path));
    const OIIO::ImageSpec& spec = image->spec();
    MapInfo info{spec.width, spec.height, 0, format_in(path, *image)};
    info.bytes_per_texel =
        is_float(info.format) ? static_cast<int>(spec.pixel_bytes(true)) : spec.nchannels * int{sizeof(std::uint16_t)};
    return info;
}

LoadedMap load_map(const fs::path& path, MapRange range, const Advance& advance) {
    constexpr double kChecked = 0.4, kDecoded = 0.9;  // parts of the time, about
    const auto reached = [&](double part) { tell(advance, part, "Reading '" + path.string() + "' was stopped"); };
    if (!(range.low < range.high) || !std::isfinite(range.high - range.low))
        fail(path, "the range's low must be below its high, both finite");
    check_file(map_name(path));
    reached(0);
    const PngCheck check = check_content(map_name(path));
    reached(kChecked);
    const auto image = open_image(map_name(path));
    auto origin = std::make_shared<MapOrigin>();
    origin->format = format_in(path, *image);
    origin->range = range;
    origin->spec = image->spec();
    if (origin->format == MapFormat::png16 && !check.states_colour)
        origin->spec.erase_attribute("oiio:ColorSpace");

    // Integer files are read as 16 bits (which widens 8 bits by 257), EXR channels as they are.
    if (!is_float(origin->format)) {
        origin->spec.set_format(OIIO::TypeDesc::UINT16);
        origin->spec.channelformats.clear();
    }
    const std::size_t pixel_bytes = origin->spec.pixel_bytes(true);
    origin->pixels.resize(origin->spec.image_pixels() * pixel_bytes);
    read_pixels(map_name(path), *image,
                is_float(origin->format) ? OIIO::TypeDesc(OIIO::TypeDesc::UNKNOWN) : origin->spec.format,
                origin->pixels.data());
    reached(kDecoded);
    HeightMap map = counts_of(path, *origin, pixel_bytes);
    origin->repeats = find_repeats(*origin, pixel_bytes);
    if (!is_float(origin->format) && origin->spec.nchannels == 1) {
        origin->pixels.clear();
        origin->pixels.shrink_to_fit();
    }
    return {std::move(map), range, origin->format, std::move(origin)};
}

}  // namespace relievo
