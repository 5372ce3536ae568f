// See albedo_file.h.
#include "renderer/albedo_file.h"

#include <OpenImageIO/imageio.h>

#include <stdexcept>
#include <string>

namespace relievo {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what) {
    throw std::invalid_argument("albedo map '" + path.string() + "': " + what);
}

void check_spec(const std::filesystem::path& path, const OIIO::ImageInput& input) {
    const OIIO::ImageSpec& spec = input.spec();
    const std::string format = input.format_name();
    constexpr int kMaxSize = 16384;
    if (spec.width < 1 || spec.height < 1 || spec.width > kMaxSize || spec.height > kMaxSize)
        fail(path, "it must have 1 to 16384 texels a side");
    if (spec.nchannels < 3)
        fail(path, "it has " + std::to_string(spec.nchannels) +
                       (spec.nchannels == 1 ? " channel" : " channels") +
                       ", must have three (RGB) or four (RGBA)");
    if ((format != "png" && format != "tiff") ||
        (spec.format != OIIO::TypeDesc::UINT8 && spec.format != OIIO::TypeDesc::UINT16))
        fail(path, "it holds " + std::string(spec.format.c_str()) + " values in the format " + format +
                       ", must be a PNG or TIFF of 8 or 16 bits");
}

}  // namespace

AlbedoFile load_albedo_file(const std::filesystem::path& path) {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);  // or colours come multiplied by alpha
    const auto input = OIIO::ImageInput::open(path.string(), &config);
    if (!input) fail(path, "cannot be opened as an image: " + OIIO::geterror());
    const OIIO::ImageSpec spec = input->spec();
    check_spec(path, *input);
    AlbedoFile file{spec.width, spec.height, spec.format == OIIO::TypeDesc::UINT8 ? 8 : 16, {}};
    const auto width = static_cast<std::size_t>(spec.width), height = static_cast<std::size_t>(spec.height);
    for (auto& plane : file.planes) plane.resize(width * height);
    std::vector<std::uint16_t> texels(3 * width * height);
    if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT16, texels.data()))
        fail(path, "cut off: " + input->geterror());
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            for (std::size_t k = 0; k < 3; ++k)
                file.planes[k][(height - 1 - y) * width + x] = texels[3 * (y * width + x) + k];
    return file;
}

}  // namespace relievo
