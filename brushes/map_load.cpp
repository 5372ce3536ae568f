// Loading displacement maps through OpenImageIO.
#include <OpenImageIO/half.h>

#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "brushes/file_check.h"
#include "brushes/map_origin.h"

namespace relievo {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
    throw std::invalid_argument("map '" + path.string() + "': " + what);
}

// The first line of what the library says, without the file name that it likes to repeat.
std::string library_error(std::string text) {
    text = text.substr(0, text.find('\n'));
    return text.empty() ? "not a readable image" : text;
}

void check_file(const fs::path& path) {
    std::error_code error;
    if (!fs::exists(path, error)) fail(path, "no such file");
    if (!fs::is_regular_file(path, error)) fail(path, "not a file");
}

PngCheck check_content(const fs::path& path) {
    const PngCheck check = check_png(path);
    if (!check.damage.empty()) fail(path, "cut off or damaged: " + check.damage);
    return check;
}

std::unique_ptr<OIIO::ImageInput> open_image(const fs::path& path) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);  // or colours come multiplied by alpha, and lose bits
    auto image = OIIO::ImageInput::open(path.string(), &config);
    if (!image) fail(path, "cannot be opened as an image: " + library_error(OIIO::geterror()));
    return image;
}

void check_spec(const fs::path& path, OIIO::ImageInput& image) {
    const OIIO::ImageSpec& spec = image.spec();
    const auto limit = std::to_string(HeightMap::kMaxSize);
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) fail(path, "the image has no texels");
    if (spec.width > HeightMap::kMaxSize || spec.height > HeightMap::kMaxSize)
        fail(path, std::to_string(spec.width) + " x " + std::to_string(spec.height) + " texels; at most " +
                       limit + " a side are possible");
    if (spec.deep || spec.depth > 1) fail(path, "deep or volume images cannot be displacement maps");
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

// Reads every row of a TIFF by itself: by whole images, the library passes strips whose checksum is wrong.
bool read_rows(OIIO::ImageInput& image, OIIO::TypeDesc type, std::byte* pixels) {
    const OIIO::ImageSpec spec = image.spec();
    const std::size_t row_bytes = static_cast<std::size_t>(spec.width * spec.nchannels) * type.size();
    for (int y = 0; y < spec.height; ++y, pixels += row_bytes)
        if (!image.read_scanline(spec.y + y, 0, type, pixels)) return false;
    return true;
}

void read_pixels(const fs::path& path, OIIO::ImageInput& image, OIIO::TypeDesc type, std::byte* pixels) {
    const OIIO::ImageSpec spec = image.spec();
    const bool by_rows = std::string_view(image.format_name()) == "tiff" && spec.tile_width == 0;
    const bool read =
        by_rows ? read_rows(image, type, pixels) : image.read_image(0, 0, 0, spec.nchannels, type, pixels);
    // The library can also note an error and go on with zeros.
    if (!read || image.has_error()) fail(path, "cut off or damaged: " + library_error(image.geterror()));
    if (image.seek_subimage(1, 0) || image.seek_subimage(0, 1))
        fail(path, "holds several images or levels; a map is a file with one");
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
    check_file(path);
    const auto image = open_image(path);
    check_spec(path, *image);
    const OIIO::ImageSpec& spec = image->spec();
    MapInfo info{spec.width, spec.height, 0, format_in(path, *image)};
    info.bytes_per_texel =
        is_float(info.format) ? static_cast<int>(spec.pixel_bytes(true)) : spec.nchannels * int{sizeof(std::uint16_t)};
    return info;
}

LoadedMap load_map(const fs::path& path, MapRange range) {
    if (!(range.low < range.high) || !std::isfinite(range.high - range.low))
        fail(path, "the range's low must be below its high, both finite");
    check_file(path);
    const PngCheck check = check_content(path);
    const auto image = open_image(path);
    check_spec(path, *image);
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
    read_pixels(path, *image,
                is_float(origin->format) ? OIIO::TypeDesc(OIIO::TypeDesc::UNKNOWN) : origin->spec.format,
                origin->pixels.data());
    HeightMap map = counts_of(path, *origin, pixel_bytes);
    origin->repeats = find_repeats(*origin, pixel_bytes);
    if (!is_float(origin->format) && origin->spec.nchannels == 1) {
        origin->pixels.clear();
        origin->pixels.shrink_to_fit();
    }
    return {std::move(map), range, origin->format, std::move(origin)};
}

}  // namespace relievo
