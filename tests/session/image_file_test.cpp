// Pictures on disk: layers by name, whole or not at all; and where a point stands in the picture.
#include "editor/session/image_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "editor/session/render_output.h"
#include "editor/session/view_window.h"
#include "tests/session/test_scene.h"

namespace relievo::image_file_test {
namespace {

DisplayPicture gradient(int width, int height) {
    DisplayPicture picture{width, height, {}};
    for (int i = 0; i < width * height * 4; ++i) picture.rgba.push_back(static_cast<std::uint8_t>(i * 7));
    return picture;
}

TEST(ImageFile, PngKeepsEveryValueUnderAnyAlpha) {
    const test::TemporaryFolder folder;
    const DisplayPicture picture = gradient(17, 9);
    write_png(folder.path() / "a.png", picture);
    EXPECT_EQ(read_display_picture(folder.path() / "a.png").rgba, picture.rgba);
}

TEST(ImageFile, ExrLayersAreFoundByNameWithInfiniteDepth) {
    const test::TemporaryFolder folder;
    FloatPicture picture{2, 1, {"R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z", "id"}, {}};
    for (int i = 0; i < 18; ++i) picture.values.push_back(static_cast<float>(i) * 0.1f);
    picture.values[4] = std::numeric_limits<float>::infinity();
    write_exr(folder.path() / "a.exr", picture);
    const auto input = OIIO::ImageInput::open((folder.path() / "a.exr").string());
    ASSERT_TRUE(input);
    const OIIO::ImageSpec spec = input->spec();
    std::vector<float> values(18);
    ASSERT_TRUE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()));
    for (std::size_t channel = 0; channel < picture.channels.size(); ++channel) {
        const int found = spec.channelindex(picture.channels[channel]);
        ASSERT_GE(found, 0) << picture.channels[channel];
        for (std::size_t pixel = 0; pixel < 2; ++pixel)
            EXPECT_EQ(values[pixel * 9 + static_cast<std::size_t>(found)],
                      picture.values[pixel * 9 + channel])
                << picture.channels[channel];
    }
}

TEST(ImageFile, UnwritablePlacesAreRefusedBeforeTheWork) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(check_writable(folder.path() / "no" / "a.png"), std::invalid_argument);
    EXPECT_THROW(check_writable(folder.path()), std::invalid_argument);
    EXPECT_THROW(check_render_output(folder.path() / "a.jpg", {}), std::invalid_argument);
    EXPECT_THROW(check_render_output(folder.path() / "a.png", {Layer::depth}), std::invalid_argument);
    check_render_output(folder.path() / "a.EXR", {Layer::depth});
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ImageFile, UnknownLayersAreNamed) {
    EXPECT_EQ(parse_aovs("Z,N,Z"), (std::vector<Layer>{Layer::depth, Layer::normal}));
    EXPECT_TRUE(parse_aovs("").empty());
    EXPECT_THROW(parse_aovs("Z,depth"), std::invalid_argument);
}

TEST(ImageFile, CutOffAndForeignPicturesAreRefused) {
    const test::TemporaryFolder folder;
    EXPECT_THROW(read_display_picture(folder.path() / "none.png"), std::invalid_argument);
    write_png(folder.path() / "a.png", gradient(64, 64));
    const std::string whole = test::read_text(folder.path() / "a.png");
    test::write_text(folder.path() / "a.png", whole.substr(0, whole.size() / 2));
    EXPECT_THROW(read_display_picture(folder.path() / "a.png"), std::invalid_argument);
    test::write_text(folder.path() / "b.png", "hello");
    EXPECT_THROW(read_display_picture(folder.path() / "b.png"), std::invalid_argument);
}

TEST(ImageFile, TheWorstPixelIsFound) {
    DisplayPicture a = gradient(10, 10), b = a;
    EXPECT_EQ(compare_pictures(a, b).rmse, 0);
    a.rgba[4 * (3 * 10 + 7) + 1] = 0;
    b.rgba[4 * (3 * 10 + 7) + 1] = 255;
    const PictureDifference difference = compare_pictures(a, b);
    EXPECT_EQ(difference.largest, 1);
    EXPECT_EQ(difference.worst_x, 7);
    EXPECT_EQ(difference.worst_y, 3);
    EXPECT_NEAR(difference.rmse, std::sqrt(1 / 300.0), 1e-12);
    EXPECT_THROW(compare_pictures(a, gradient(5, 20)), std::invalid_argument);
}

TEST(ViewWindow, StaysInThePictureAtEveryBorder) {
    for (const glm::dvec2 centre : {glm::dvec2(-50, 300), {0, 0}, {640, 480}, {1e9, -1e9}, {320.5, 240.2}}) {
        const PixelRect window = window_around(centre, 256, 640, 480);
        EXPECT_EQ(window.x1 - window.x0, 256);
        EXPECT_EQ(window.y1 - window.y0, 256);
        EXPECT_TRUE(window.x0 >= 0 && window.y0 >= 0 && window.x1 <= 640 && window.y1 <= 480);
    }
    const PixelRect whole = window_around({10, 10}, 256, 100, 50);
    EXPECT_EQ(whole.x1, 100);
    EXPECT_EQ(whole.y1, 50);
}

TEST(ViewWindow, PointsBehindTheEyeHaveNoPlace) {
    Camera camera;  // at z = 3, looks down on the origin
    const auto centre = project(camera, glm::dvec3(0), 640, 480, {0, 0, 0});
    ASSERT_TRUE(centre);
    EXPECT_NEAR(centre->x, 320, 1e-9);
    EXPECT_NEAR(centre->y, 240, 1e-9);
    EXPECT_LT(project(camera, glm::dvec3(0), 640, 480, {0, 0.5f, 0})->y, 240) << "row 0 is at the top";
    EXPECT_GT(project(camera, glm::dvec3(0), 640, 480, {0.5f, 0, 0})->x, 320);
    EXPECT_FALSE(project(camera, glm::dvec3(0), 640, 480, {0, 0, 4}));
}

}  // namespace
}  // namespace relievo::image_file_test
