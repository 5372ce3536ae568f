// See image_write.h.
#include "brushes/image_write.h"

#include <OpenImageIO/filesystem.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace relievo {
namespace {

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

// By parts of some rows: of a large image each takes some hundredths of a second. Files are the same as those written at
// once, as long as a part is a whole number of a TIFF's strips.
int rows_at_a_time(const OIIO::ImageSpec& spec) {
    constexpr int kRows = 64;
    const int unit = spec.tile_width > 0 ? spec.tile_height : std::max(1, spec.get_int_attribute("tiff:RowsPerStrip", 32));
    return (kRows + unit - 1) / unit * unit;
}

bool write_rows(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec, int begin, int end, const std::byte* pixels) {
    const OIIO::TypeDesc type = spec.channelformats.empty() ? spec.format : OIIO::TypeDesc(OIIO::TypeDesc::UNKNOWN);
    if (spec.tile_width == 0) return output.write_scanlines(spec.y + begin, spec.y + end, 0, type, pixels);
    return output.write_tiles(spec.x, spec.x + spec.width, spec.y + begin, spec.y + end, 0, 1, type, pixels);
}

}  // namespace

void keep_metadata(OIIO::ImageSpec& spec, const OIIO::ImageSpec& origin, bool same_format) {
    std::vector<OIIO::ParamValue> kept;
    for (const OIIO::ParamValue& attribute : origin.extra_attribs) {
        const std::string_view name(attribute.name().data(), attribute.name().size());
        if (!is_encoding(name) && (same_format || !is_format_bound(name))) kept.push_back(attribute);
    }
    spec.extra_attribs.clear();
    for (const OIIO::ParamValue& attribute : kept) spec.extra_attribs.push_back(attribute);
    make_lossless(spec);
}

void stop_the_clock(OIIO::ImageSpec& spec) {
    if (!spec.find_attribute("DateTime")) spec.attribute("DateTime", "    :  :     :  :  ");
}

std::vector<unsigned char> encoded_image(const std::filesystem::path& path, const char* kind,
                                         const char* writer, const OIIO::ImageSpec& spec,
                                         std::span<const std::byte> pixels, const Advance& advance) {
    const auto fail = [&](const std::string& what) {
        throw std::invalid_argument("cannot write " + std::string(kind) + " '" + path.string() +
                                    "': " + what);
    };
    std::vector<unsigned char> file;
    OIIO::Filesystem::IOVecOutput memory(file);
    const auto output = OIIO::ImageOutput::create(writer);
    if (!output) fail("OpenImageIO was built without " + std::string(writer));
    output->set_ioproxy(&memory);
    // The name only serves the writer's messages: the bytes go to memory.
    if (!output->open(path.filename().string(), spec)) fail(output->geterror());
    const std::size_t row_bytes = static_cast<std::size_t>(spec.width) * spec.pixel_bytes(true);
    for (int begin = 0, rows = rows_at_a_time(spec); begin < spec.height; begin += rows) {
        tell(advance, static_cast<double>(begin) / spec.height, not_written(path.string()));
        const std::byte* const part = pixels.data() + static_cast<std::size_t>(begin) * row_bytes;
        if (!write_rows(*output, spec, begin, std::min(begin + rows, spec.height), part)) fail(output->geterror());
    }
    if (!output->close()) fail(output->geterror());
    return file;
}

}  // namespace relievo
