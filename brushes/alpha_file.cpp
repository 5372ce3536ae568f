// A stamp's image as a file, through OpenImageIO.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <stdexcept>
#include <string>
#include <system_error>

#include "brushes/alpha.h"
#include "brushes/atomic_file.h"
#include "brushes/file_check.h"

namespace relievo {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail_alpha(const fs::path& path, const std::string& what) {
    throw std::invalid_argument("alpha '" + path.string() + "': " + what);
}

std::string first_line(const std::string& text) {
    return text.empty() ? "not a readable image" : text.substr(0, text.find('\n'));
}

// Channels of a pixel, already multiplied by the file's alpha channel, to grey.
float grey(const float* pixel, int channels, int alpha_channel) {
    const bool colour = channels >= 3 && (alpha_channel < 0 || alpha_channel >= 3);
    if (colour) return 0.2126f * pixel[0] + 0.7152f * pixel[1] + 0.0722f * pixel[2];
    return pixel[0];
}

}  // namespace

std::shared_ptr<const Alpha> load_alpha(const fs::path& path) {
    std::error_code error;
    if (!fs::exists(path, error)) fail_alpha(path, "no such file");
    if (!fs::is_regular_file(path, error)) fail_alpha(path, "not a file");
    if (const PngCheck check = check_png(path); !check.damage.empty())
        fail_alpha(path, "cut off or damaged: " + check.damage);
    const auto image = OIIO::ImageInput::open(path.string());
    if (!image) fail_alpha(path, "cannot be opened as an image: " + first_line(OIIO::geterror()));
    const OIIO::ImageSpec& spec = image->spec();
    const int width = spec.width, height = spec.height, channels = spec.nchannels;
    if (width < 1 || height < 1 || channels < 1) fail_alpha(path, "the image has no pixels");
    if (width > Alpha::kMaxSize || height > Alpha::kMaxSize)
        fail_alpha(path, std::to_string(width) + " x " + std::to_string(height) + " pixels; at most " +
                       std::to_string(Alpha::kMaxSize) + " a side are possible: scale it down");
    if (spec.deep || spec.depth > 1) fail_alpha(path, "deep or volume images cannot be stamped");
    const int alpha_channel = spec.alpha_channel;
    const std::size_t stride = static_cast<std::size_t>(channels);
    std::vector<float> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * stride);
    const bool read = image->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, pixels.data());
    if (!read || image->has_error()) fail_alpha(path, "cut off or damaged: " + first_line(image->geterror()));
    std::vector<float> values;
    values.reserve(pixels.size() / stride);
    for (int y = height - 1; y >= 0; --y)  // files have their top row first
        for (int x = 0; x < width; ++x) {
            const auto pixel =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
            values.push_back(grey(pixels.data() + pixel * stride, channels, alpha_channel));
        }
    return std::make_shared<const Alpha>(path, width, height, std::move(values));
}

void save_alpha(const Alpha& alpha, const fs::path& path) {
    const auto side = static_cast<std::ptrdiff_t>(alpha.width());
    std::vector<float> rows;  // the top one first
    rows.reserve(alpha.values().size());
    for (std::ptrdiff_t y = alpha.height() - 1; y >= 0; --y) {
        const auto row = alpha.values().begin() + y * side;
        rows.insert(rows.end(), row, row + side);
    }
    std::vector<unsigned char> file;
    OIIO::Filesystem::IOVecOutput memory(file);
    OIIO::ImageSpec spec(alpha.width(), alpha.height(), 1, OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "zip");
    const auto writer = OIIO::ImageOutput::create("openexr");
    if (!writer) fail_alpha(path, "OpenImageIO was built without openexr");
    writer->set_ioproxy(&memory);
    // The name only serves the writer's messages: the bytes go to memory.
    if (!writer->open(path.filename().string(), spec) ||
        !writer->write_image(OIIO::TypeDesc::FLOAT, rows.data()) || !writer->close())
        fail_alpha(path, writer->geterror());
    write_file_atomically(path, std::as_bytes(std::span(file)));
}

}  // namespace relievo
