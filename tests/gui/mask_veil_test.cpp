// What the mask protects, over a picture from a device's layers; skipped without one.
#include "editor/gui/mask_veil.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/vulkan/context.h"
#include "tests/session/on_device.h"

namespace relievo::gui::mask_veil_test {
namespace {

constexpr int kWidth = 64, kHeight = 48;
constexpr PixelRect kAll{0, 0, kWidth, kHeight};

class MaskVeils : public test::OnDevice {
  protected:
    void SetUp() override {
        OnDevice::SetUp();
        if (IsSkipped()) return;
        session_.emplace(test::write_scene(folder_.path()), on_device(kWidth, kHeight));
        veil_.reset({kWidth, kHeight});
        veil_.take(std::vector<std::uint8_t>(std::size_t{kWidth} * kHeight * 4, 200), kAll);
    }

    void collect(const PixelRect& window) {
        session_->renderer().trace_layers(window);
        veil_.collect(session_->renderer(), window);
    }
    // How many pixels of the painted veil are so bright.
    std::ptrdiff_t count(std::uint8_t brightness) const {
        std::ptrdiff_t pixels = 0;
        for (std::size_t i = 0; i < veil_.rgba().size(); i += 4) pixels += veil_.rgba()[i] == brightness;
        return pixels;
    }
    std::ptrdiff_t pixels_on_surface() {
        return std::ranges::count(session_->renderer().read_back(Layer::id), 1.0f);
    }

    std::optional<Session> session_;
    MaskVeil veil_;
};

TEST_F(MaskVeils, fullMaskDarkensTheSurfaceAndNothingElse) {
    collect(kAll);
    const HeightMap mask(1, 1, 65535);
    veil_.paint(kAll, &mask, Wrap::repeat);
    ASSERT_GT(pixels_on_surface(), 0);
    EXPECT_EQ(count(70), pixels_on_surface());
    EXPECT_EQ(count(200), kWidth * kHeight - pixels_on_surface());
}

TEST_F(MaskVeils, emptyMaskAndNoMaskLeaveThePicture) {
    collect(kAll);
    const HeightMap mask(3, 2, 0);
    veil_.paint(kAll, &mask, Wrap::clamp);
    EXPECT_EQ(count(200), kWidth * kHeight);
    veil_.paint(kAll, nullptr, Wrap::clamp);
    EXPECT_EQ(count(200), kWidth * kHeight);
}

TEST_F(MaskVeils, whatWasNotTracedStaysClearUntilItIs) {
    collect({0, 0, kWidth, kHeight / 2});
    EXPECT_FALSE(veil_.knows_all());
    const HeightMap mask(1, 1, 65535);
    veil_.paint(kAll, &mask, Wrap::repeat);
    EXPECT_LT(count(70), pixels_on_surface());
    collect({0, kHeight / 2, kWidth, kHeight});
    EXPECT_TRUE(veil_.knows_all());
    veil_.paint(kAll, &mask, Wrap::repeat);
    EXPECT_EQ(count(70), pixels_on_surface());
}

TEST(MaskVeil, nothingIsLeftOfAVeilWithoutSize) {
    MaskVeil veil;
    veil.reset({});
    veil.paint({0, 0, 0, 0}, nullptr, Wrap::repeat);
    EXPECT_TRUE(veil.rgba().empty());
    EXPECT_FALSE(veil.knows_all());
}

}  // namespace
}  // namespace relievo::gui::mask_veil_test
