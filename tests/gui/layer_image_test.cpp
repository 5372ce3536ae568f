// The numbers of a view and their colours, from a device's layers; skipped without one.
#include "editor/gui/layer_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "renderer/vulkan/context.h"
#include "tests/session/on_device.h"

namespace relievo::gui::layer_image_test {
namespace {

constexpr int kWidth = 64, kHeight = 48;
constexpr PixelRect kAll{0, 0, kWidth, kHeight};

class LayerImages : public test::OnDevice {
  protected:
    void SetUp() override {
        OnDevice::SetUp();
        if (IsSkipped()) return;
        session_.emplace(test::write_scene(folder_.path()), on_device(kWidth, kHeight));
    }

    LayerImage image_of(View view, const Palette& palette) {
        LayerImage image;
        image.reset({kWidth, kHeight}, view);
        session_->renderer().trace_layers(kAll, view == View::steps);
        image.collect(session_->renderer(), kAll, RayCount::boxes, *session_);
        image.paint(kAll, palette);
        return image;
    }
    static Rgb pixel(const LayerImage& image, int x, int y) {
        const std::uint8_t* from = image.rgba().data() + static_cast<std::size_t>(y * kWidth + x) * 4;
        return {from[0], from[1], from[2]};
    }
    // The method's own depths as the reference's, but for what `change` makes of them.
    template <typename Change>
    ReferencePicture reference(Change change) {
        const auto depth = session_->renderer().read_back(Layer::depth);
        ReferencePicture picture(kWidth, kHeight);
        for (int step = ReferencePicture::kCoarsest; step > 0; step /= 2)
            for (int row = 0; row < kHeight; row += step) {
                ReferencePicture::Strip strip{step, row, {}, {}};
                for (const int x : ReferencePicture::columns(kWidth, step, row)) {
                    const auto own = static_cast<double>(depth[static_cast<std::size_t>(row * kWidth + x)]);
                    strip.depth.push_back(change(x, row, own));
                    strip.object.push_back(std::isfinite(strip.depth.back()) ? 1 : 0);
                }
                picture.add(strip);
            }
        return picture;
    }

    std::optional<Session> session_;
};

TEST_F(LayerImages, HeightsAreTheMapsWhereTheSurfaceIsAndNothingElsewhere) {
    const Palette palette{View::height, ColourScale::diverging(0.2), nullptr, {}};
    const LayerImage image = image_of(View::height, palette);
    EXPECT_EQ(pixel(image, 0, 0), kNothing);
    EXPECT_NE(pixel(image, kWidth / 2, kHeight / 2), kNothing);
    // The test map's counts are 30000 + 61 x + 17 y.
    const Displacement& d = session_->scene().objects.front().displacement;
    EXPECT_LE(image.quantile(1), std::abs(d.amplitude * (30000 / 65535.0 - d.midlevel)) * 1.001);
    EXPECT_GT(image.quantile(1), 0);
}

TEST_F(LayerImages, AReferenceOfItsOwnDepthsShowsNoError) {
    const ReferencePicture same = reference([](int, int, double depth) { return depth; });
    const Palette palette{View::error, ColourScale::logarithmic(1e-7, 1), &same,
                          error_units(session_->scene())};
    const LayerImage image = image_of(View::error, palette);
    EXPECT_EQ(pixel(image, kWidth / 2, kHeight / 2), palette.scale.colour(0));
    EXPECT_EQ(pixel(image, 0, 0), kNothing);
    const ErrorSummary errors = image.errors(palette, 1);
    EXPECT_GT(errors.pixels, 200u);
    EXPECT_EQ(errors.missed + errors.invented, 0u);
    EXPECT_EQ(errors.largest, 0);
}

TEST_F(LayerImages, MissedAndInventedPixelsAreMarkedAndCounted) {
    const ReferencePicture other = reference([](int x, int y, double depth) {
        if (x == kWidth / 2 && y == kHeight / 2) return std::numeric_limits<double>::infinity();
        if (x == 0 && y == 0) return 3.0;
        return depth + 0.002;  // a hundredth of the amplitude
    });
    const Palette palette{View::error, ColourScale::logarithmic(1e-7, 1), &other,
                          error_units(session_->scene())};
    const LayerImage image = image_of(View::error, palette);
    EXPECT_EQ(pixel(image, kWidth / 2, kHeight / 2), kInvented);
    EXPECT_EQ(pixel(image, 0, 0), kMissed);
    const ErrorSummary errors = image.errors(palette, 1);
    EXPECT_EQ(errors.missed, 1u);
    EXPECT_EQ(errors.invented, 1u);
    EXPECT_NEAR(errors.median, 0.01, 1e-4);
    EXPECT_NEAR(errors.largest, 0.01, 1e-4);
    EXPECT_LT(image.errors(palette, 4).pixels, errors.pixels / 10);
}

TEST_F(LayerImages, WithoutAReferenceTheShapeShowsInGrey) {
    const Palette palette{View::error, ColourScale::logarithmic(1e-7, 1), nullptr,
                          error_units(session_->scene())};
    const Rgb middle = pixel(image_of(View::error, palette), kWidth / 2, kHeight / 2);
    EXPECT_LT(std::abs(middle.r - middle.b), 20);
    EXPECT_GT(middle.r, kNotKnown.r / 4);
}

TEST_F(LayerImages, CostsAreCountedOfRaysThatMetABoxOnly) {
    const Palette palette{View::steps, ColourScale::heat(4), nullptr, {}};
    const LayerImage image = image_of(View::steps, palette);
    EXPECT_EQ(pixel(image, 0, 0), kNothing);
    EXPECT_GE(image.quantile(0), 1);
}

}  // namespace
}  // namespace relievo::gui::layer_image_test
