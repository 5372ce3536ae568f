// Images for the stamp: values, files of every kind, and what is refused.
#include "brushes/alpha.h"

#include <gtest/gtest.h>

#include <limits>

#include "image_files.h"

namespace relievo::alpha_test {
namespace {

TEST(Alpha, refuses_bad_sizes_and_values_by_pixel) {
    const auto message = [](int width, int height, std::vector<float> values) {
        try {
            Alpha("a.exr", width, height, std::move(values));
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string("taken");
    };
    EXPECT_EQ(message(0, 1, {}), "alpha 'a.exr': 0 x 1 pixels; each side must be 1 to 4096");
    EXPECT_EQ(message(2, 1, {0.0f}), "alpha 'a.exr': has 1 values for 2 x 1 pixels");
    EXPECT_EQ(message(1, 2, {0.0f, std::numeric_limits<float>::quiet_NaN()}),
              "alpha 'a.exr': NaN at pixel (0, 1), counted from the lower left; every value must be finite");
    EXPECT_EQ(message(1, 1, {1e-30f}), "taken");
}

TEST(Alpha, values_beyond_one_are_scaled_and_holes_stay_holes) {
    const Alpha alpha("a", 2, 1, {-4.0f, 2.0f});
    EXPECT_EQ(alpha.at(-0.5, 0, 0), -1.0f);
    EXPECT_EQ(alpha.at(0.5, 0, 0), 0.5f);
    EXPECT_EQ(alpha.largest(), 4.0f);
    EXPECT_EQ(Alpha("a", 1, 1, {0.5f}).largest(), 1.0f);
    EXPECT_EQ(alpha.at(0, 0, 0), -0.25f);
    EXPECT_EQ(alpha.at(0.5, 0.51, 0), 0.0f) << "above a wide image";
    EXPECT_EQ(alpha.at(0, 0, 100.0), -0.25f) << "the coarsest level";
    EXPECT_EQ(alpha.at(std::numeric_limits<double>::quiet_NaN(), 0, 0), 0.0f);
}

OIIO::ImageSpec spec_of(int width, int height, int channels, OIIO::TypeDesc type) {
    return {width, height, channels, type};
}

TEST(AlphaFile, grey_of_8_and_16_bits_and_float_with_its_first_row_on_top) {
    const TestFolder folder;
    const std::uint8_t small[] = {0, 51, 255, 102};
    write_image(folder / "8.png", spec_of(2, 2, 1, OIIO::TypeDesc::UINT8), small);
    const auto eight = load_alpha(folder / "8.png");
    EXPECT_EQ(eight->at(-0.5, 0.5, 0), 0.0f);
    EXPECT_FLOAT_EQ(eight->at(0.5, 0.5, 0), 0.2f);
    EXPECT_EQ(eight->at(-0.5, -0.5, 0), 1.0f);
    EXPECT_FLOAT_EQ(eight->at(0.5, -0.5, 0), 0.4f);
    const std::uint16_t wide[] = {1};
    write_image(folder / "16.tif", spec_of(1, 1, 1, OIIO::TypeDesc::UINT16), wide);
    EXPECT_FLOAT_EQ(load_alpha(folder / "16.tif")->at(0, 0, 0), 1 / 65535.0f);
    const float real[] = {-0.375f};
    write_image(folder / "f.exr", spec_of(1, 1, 1, OIIO::TypeDesc::FLOAT), real);
    EXPECT_EQ(load_alpha(folder / "f.exr")->at(0, 0, 0), -0.375f);
}

TEST(AlphaFile, colours_become_their_luminance_and_what_is_transparent_stamps_nothing) {
    const TestFolder folder;
    const std::uint8_t pixels[] = {255, 0, 0, 255, 255, 255, 255, 0};
    auto spec = spec_of(2, 1, 4, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    write_image(folder / "c.png", spec, pixels);
    const auto alpha = load_alpha(folder / "c.png");
    EXPECT_FLOAT_EQ(alpha->at(-0.5, 0, 0), 0.2126f);
    EXPECT_EQ(alpha->at(0.5, 0, 0), 0.0f);
}

TEST(AlphaFile, the_hash_is_of_the_values_not_of_the_file) {
    const TestFolder folder;
    const std::uint8_t pixels[] = {10, 20, 30, 40};
    write_image(folder / "a.png", spec_of(2, 2, 1, OIIO::TypeDesc::UINT8), pixels);
    write_image(folder / "a.tif", spec_of(2, 2, 1, OIIO::TypeDesc::UINT8), pixels);
    write_image(folder / "b.png", spec_of(4, 1, 1, OIIO::TypeDesc::UINT8), pixels);
    EXPECT_EQ(load_alpha(folder / "a.png")->hash(), load_alpha(folder / "a.tif")->hash());
    EXPECT_NE(load_alpha(folder / "a.png")->hash(), load_alpha(folder / "b.png")->hash());
}

TEST(AlphaFile, saved_it_reads_back_bit_for_bit) {
    const TestFolder folder;
    const Alpha alpha("a", 3, 2, {0.1f, -1.0f / 3, 1e-30f, 0.5f, 1.0f, -0.0f});
    save_alpha(alpha, folder / "a.exr");
    EXPECT_EQ(load_alpha(folder / "a.exr")->hash(), alpha.hash());
    EXPECT_THROW(save_alpha(alpha, folder / "none/a.exr"), std::invalid_argument);
}

TEST(AlphaFile, what_cannot_be_stamped_is_refused_with_file_and_reason) {
    const TestFolder folder;
    const auto refused = [&](const std::string& name, const std::string& reason) {
        try {
            load_alpha(folder / name);
            ADD_FAILURE() << name << " was taken";
        } catch (const std::invalid_argument& error) {
            const std::string message = error.what();
            EXPECT_NE(message.find(name), std::string::npos) << message;
            EXPECT_NE(message.find(reason), std::string::npos) << message;
        }
    };
    refused("none.png", "no such file");
    std::filesystem::create_directory(folder / "folder");
    refused("folder", "not a file");
    write_bytes(folder / "text.png", "no image");
    refused("text.png", "cannot be opened");
    const std::uint8_t pixels[64 * 64] = {};
    write_image(folder / "cut.png", spec_of(64, 64, 1, OIIO::TypeDesc::UINT8), pixels);
    write_bytes(folder / "cut.png", bytes_of(folder / "cut.png").substr(0, 60));
    refused("cut.png", "cut off or damaged");
    const float bad[] = {0.0f, std::numeric_limits<float>::infinity()};
    write_image(folder / "bad.exr", spec_of(2, 1, 1, OIIO::TypeDesc::FLOAT), bad);
    refused("bad.exr", "infinity at pixel (1, 0)");
    const std::vector<std::uint8_t> row(4097);
    write_image(folder / "long.png", spec_of(4097, 1, 1, OIIO::TypeDesc::UINT8), row.data());
    refused("long.png", "4097 x 1 pixels; at most 4096 a side");
}

}  // namespace
}  // namespace relievo::alpha_test
