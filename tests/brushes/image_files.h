// Images for the tests, written and read by OpenImageIO directly; a folder of one test's own.
#pragma once

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace relievo {

class TestFolder {
  public:
    TestFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "relievo-maps-XXXXXX").string();
        path_ = ::mkdtemp(name.data());
    }
    ~TestFolder() { std::filesystem::remove_all(path_); }
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::directory_iterator(path_))
            found.push_back(entry.path().filename().string());
        return found;
    }

  private:
    std::filesystem::path path_;
};

inline void write_image(const std::filesystem::path& path, const OIIO::ImageSpec& spec, const void* pixels) {
    auto out = OIIO::ImageOutput::create(path.string());
    ASSERT_TRUE(out && out->open(path.string(), spec)) << OIIO::geterror();
    const bool mixed = !spec.channelformats.empty();
    ASSERT_TRUE(out->write_image(mixed ? OIIO::TypeDesc(OIIO::TypeDesc::UNKNOWN) : spec.format, pixels))
        << out->geterror();
    ASSERT_TRUE(out->close());
}

struct Image {
    OIIO::ImageSpec spec;
    std::vector<char> pixels;  // in the file's own formats
};

inline Image read_image(const std::filesystem::path& path) {
    Image image;
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    auto in = OIIO::ImageInput::open(path.string(), &config);
    EXPECT_TRUE(in) << OIIO::geterror();
    if (!in) return image;
    image.spec = in->spec();
    image.pixels.resize(image.spec.image_bytes(true));
    EXPECT_TRUE(in->read_image(0, 0, 0, image.spec.nchannels, OIIO::TypeDesc::UNKNOWN, image.pixels.data()));
    return image;
}

inline std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace relievo
