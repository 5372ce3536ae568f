// Colour maps on disk: 8 and 16 bits stay, all else of the file stays, and what cannot serve is refused.
#include "brushes/colour_file.h"

#include <cstring>
#include <stdexcept>

#include "image_files.h"

namespace relievo::colour_file_test {
namespace {

ColourMap ramp(int width, int height, int bits) {
    ColourMap map(width, height, bits);
    int value = 0;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::uint16_t& texel : map.plane(k).texels())
            texel = static_cast<std::uint16_t>(bits == 8 ? value++ % 256 * 257 : (value += 4801) % 65536);
    return map;
}

template <typename Value>
std::vector<Value> values(std::size_t count) {
    std::vector<Value> all(count);
    for (std::size_t i = 0; i < count; ++i) all[i] = static_cast<Value>(i * 7919 + 13);
    return all;
}

std::string refusal(const std::filesystem::path& path) {
    try {
        load_colours(path);
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "";
}

TEST(ColourFile, every_value_of_8_and_16_bits_survives_in_both_formats) {
    const TestFolder folder;
    for (const int bits : {8, 16})
        for (const char* name : {"a.png", "a.tif"}) {
            const ColourMap map = ramp(160, 103, bits);
            save_colours(map, folder / name);
            const LoadedColours loaded = load_colours(folder / name);
            EXPECT_EQ(loaded.map.bits(), bits) << name;
            EXPECT_EQ(loaded.map.hash(), map.hash()) << name;
            EXPECT_EQ(colour_info(folder / name).bits, bits);
            EXPECT_EQ(read_image(folder / name).spec.format.size(), static_cast<std::size_t>(bits / 8));
        }
}

TEST(ColourFile, lowest_row_comes_first) {
    const TestFolder folder;
    const std::uint8_t pixels[] = {1, 2, 3, 4, 5, 6};
    write_image(folder / "a.png", OIIO::ImageSpec(1, 2, 3, OIIO::TypeDesc::UINT8), pixels);
    const ColourMap map = load_colours(folder / "a.png").map;
    EXPECT_EQ(map.plane(0).at(0, 0), 4 * 257);
    EXPECT_EQ(map.plane(2).at(0, 1), 3 * 257);
}

TEST(ColourFile, alpha_and_metadata_are_kept_through_an_edit) {
    const TestFolder folder;
    for (const char* name : {"a.png", "a.tif"}) {
        OIIO::ImageSpec spec(9, 7, 4, OIIO::TypeDesc::UINT16);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        spec.attribute("ImageDescription", "bark");
        const auto pixels = values<std::uint16_t>(9 * 7 * 4);
        write_image(folder / name, spec, pixels.data());
        LoadedColours loaded = load_colours(folder / name);
        loaded.map.plane(1).set(3, 2, 12345);
        save_colours(loaded.map, folder / name, loaded.origin.get());
        const Image saved = read_image(folder / name);
        EXPECT_EQ(saved.spec.get_string_attribute("ImageDescription"), "bark");
        ASSERT_EQ(saved.spec.nchannels, 4);
        std::vector<std::uint16_t> expected = pixels;
        expected[static_cast<std::size_t>(((7 - 1 - 2) * 9 + 3) * 4 + 1)] = 12345;
        const auto* got = reinterpret_cast<const std::uint16_t*>(saved.pixels.data());
        EXPECT_EQ(std::vector<std::uint16_t>(got, got + expected.size()), expected) << name;
    }
}

TEST(ColourFile, another_format_keeps_alpha_and_what_means_something_there) {
    const TestFolder folder;
    OIIO::ImageSpec spec(5, 5, 4, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("ImageDescription", "moss");
    const auto pixels = values<std::uint8_t>(100);
    write_image(folder / "a.png", spec, pixels.data());
    const LoadedColours loaded = load_colours(folder / "a.png");
    save_colours(loaded.map, folder / "b.tif", loaded.origin.get());
    const Image saved = read_image(folder / "b.tif");
    EXPECT_EQ(saved.spec.get_string_attribute("ImageDescription"), "moss");
    ASSERT_EQ(saved.pixels.size(), pixels.size());
    EXPECT_EQ(std::memcmp(saved.pixels.data(), pixels.data(), pixels.size()), 0);
}

TEST(ColourFile, what_cannot_serve_is_refused_by_name_and_reason) {
    const TestFolder folder;
    const auto has = [](const std::string& text, const std::string& part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    has(refusal(folder / "none.png"), "none.png': no such file");
    const auto grey = values<std::uint8_t>(64);
    write_image(folder / "grey.png", OIIO::ImageSpec(8, 8, 1, OIIO::TypeDesc::UINT8), grey.data());
    has(refusal(folder / "grey.png"), "has 1 channel; a colour map has three (RGB) or four (RGBA)");
    const auto floats = values<float>(12);
    write_image(folder / "a.exr", OIIO::ImageSpec(2, 2, 3, OIIO::TypeDesc::FLOAT), floats.data());
    has(refusal(folder / "a.exr"), "holds float values in the format openexr");
    write_bytes(folder / "text.png", "no picture");
    has(refusal(folder / "text.png"), "cannot be opened as an image");
    save_colours(ramp(64, 64, 16), folder / "cut.png");
    const std::string whole = bytes_of(folder / "cut.png");
    write_bytes(folder / "cut.png", whole.substr(0, whole.size() / 2));
    has(refusal(folder / "cut.png"), "cut off or damaged");
}

TEST(ColourFile, failing_to_save_leaves_the_old_file) {
    const TestFolder folder;
    const ColourMap map = ramp(4, 4, 8);
    EXPECT_THROW(save_colours(map, folder / "a.exr"), std::invalid_argument);
    EXPECT_THROW(save_colours(map, folder / "no/such/a.png"), std::invalid_argument);
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace relievo::colour_file_test
