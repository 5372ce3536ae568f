// Pictures on disk: 8-bit PNG for people, float EXR with named layers for programs.
#include "editor/session/image_file.h"

#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <span>
#include <stdexcept>

#include "brushes/atomic_file.h"
#include "brushes/file_check.h"
#include "brushes/image_write.h"

namespace relievo {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
    throw std::invalid_argument(path.string() + ": " + what);
}

// Encoded in memory first, so that the file itself is written in one place, atomically.
template <typename Value>
void encode_and_write(const fs::path& path, const char* format, const OIIO::ImageSpec& spec,
                      const std::vector<Value>& values, const Advance& advance = {}) {
    check_writable(path);
    const std::vector<unsigned char> bytes =
        encoded_image(path, "picture", format, spec, std::as_bytes(std::span(values)), within(advance, 0, kEncoded));
    write_file_atomically(path, std::as_bytes(std::span(bytes)), within(advance, kEncoded, 1));
}

}  // namespace

void put_columns(DisplayPicture& picture, const std::vector<std::uint8_t>& rgba, int x0, int x1) {
    const auto row = static_cast<std::ptrdiff_t>(picture.width) * 4;
    for (std::ptrdiff_t at = 0; at < row * picture.height; at += row)
        std::copy(rgba.begin() + at + x0 * 4, rgba.begin() + at + x1 * 4, picture.rgba.begin() + at + x0 * 4);
}

void check_writable(const fs::path& path) {
    const fs::path folder = path.parent_path().empty() ? fs::path(".") : path.parent_path();
    if (path.filename().empty()) fail(path, "must name a file");
    if (!fs::is_directory(folder)) fail(path, "there is no folder " + folder.string());
    if (fs::is_directory(path)) fail(path, "is a folder, must be a file");
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        fail(path, std::string("cannot write there: ") + std::strerror(errno));
    if (fs::exists(path) && access(path.c_str(), W_OK) != 0)
        fail(path, std::string("cannot be overwritten: ") + std::strerror(errno));
}

void write_png(const fs::path& path, const DisplayPicture& picture, const Advance& advance) {
    OIIO::ImageSpec spec(picture.width, picture.height, 4, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);  // the values are final: no scaling by alpha
    encode_and_write(path, "png", spec, picture.rgba, advance);
}

void write_jpeg(const fs::path& path, const DisplayPicture& picture) {
    OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("compression", "jpeg:92");
    std::vector<std::uint8_t> rgb;
    rgb.reserve(picture.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        rgb.insert(rgb.end(), {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]});
    encode_and_write(path, "jpeg", spec, rgb);
}

void write_exr(const fs::path& path, const FloatPicture& picture, const Advance& advance) {
    OIIO::ImageSpec spec(picture.width, picture.height, static_cast<int>(picture.channels.size()),
                         OIIO::TypeDesc::FLOAT);
    spec.channelnames = picture.channels;
    for (std::size_t i = 0; i < picture.channels.size(); ++i) {
        if (picture.channels[i] == "A") spec.alpha_channel = static_cast<int>(i);
        if (picture.channels[i] == "Z") spec.z_channel = static_cast<int>(i);
    }
    spec.attribute("compression", "zip");
    spec.attribute("oiio:ColorSpace", "linear");
    encode_and_write(path, "openexr", spec, picture.values, advance);
}

DisplayPicture read_display_picture(const fs::path& path) {
    if (!fs::exists(path)) fail(path, "no such picture");
    // First, because libpng prints about a damaged file by itself, and leaks.
    if (const PngCheck check = check_png(path); !check.damage.empty())
        fail(path, "is a damaged picture: " + check.damage);
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path.string(), &config);
    if (!input) fail(path, "cannot be read as a picture: " + OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.nchannels < 3 || spec.format != OIIO::TypeDesc::UINT8)
        fail(path, "must be an 8-bit RGB or RGBA picture");
    DisplayPicture picture{spec.width, spec.height, {}};
    const auto pixels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<std::uint8_t> values(pixels * channels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, values.data()))
        fail(path, "cannot be read to its end: " + input->geterror());
    picture.rgba.assign(pixels * 4, 255);
    for (std::size_t i = 0; i < pixels; ++i)
        std::memcpy(&picture.rgba[i * 4], &values[i * channels], channels >= 4 ? 4 : 3);
    return picture;
}

PictureDifference compare_pictures(const DisplayPicture& a, const DisplayPicture& b) {
    if (a.width != b.width || a.height != b.height)
        throw std::invalid_argument("the pictures' sizes differ: " + std::to_string(a.width) + "x" +
                                    std::to_string(a.height) + " and " + std::to_string(b.width) + "x" +
                                    std::to_string(b.height));
    PictureDifference difference;
    double sum = 0;
    int largest = 0;
    const std::size_t pixels = a.rgba.size() / 4;
    for (std::size_t i = 0; i < pixels; ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int apart = std::abs(int{a.rgba[i * 4 + channel]} - int{b.rgba[i * 4 + channel]});
            sum += static_cast<double>(apart) * apart;
            if (apart <= largest) continue;
            largest = apart;
            difference.worst_x = static_cast<int>(i % static_cast<std::size_t>(a.width));
            difference.worst_y = static_cast<int>(i / static_cast<std::size_t>(a.width));
        }
    }
    difference.rmse = pixels > 0 ? std::sqrt(sum / (3.0 * static_cast<double>(pixels))) / 255 : 0;
    difference.largest = largest / 255.0;
    return difference;
}

}  // namespace relievo
