// Scales of the views: what a colour says, and what the colour bar says about it.
#include "editor/gui/colour_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace relievo::gui::colour_scale_test {
namespace {

int brightness(const Rgb& c) {
    return 2 * c.r + 5 * c.g + c.b;
}

TEST(ColourScale, HeatAndErrorsGrowBrighterAllTheWay) {
    for (const ColourScale& scale : {ColourScale::heat(50), ColourScale::logarithmic(1e-7, 1)}) {
        for (double share = 0.02; share <= 1; share += 0.02)
            EXPECT_GT(brightness(scale.colour_at(share)), brightness(scale.colour_at(share - 0.02)));
    }
}

TEST(ColourScale, ZeroIsNeutralBetweenBlueAndRed) {
    const ColourScale scale = ColourScale::diverging(0.2);
    const Rgb zero = scale.colour(0), low = scale.colour(-0.2), high = scale.colour(0.2);
    EXPECT_LT(std::abs(zero.r - zero.b), 4);
    EXPECT_GT(low.b, low.r + 80);
    EXPECT_GT(high.r, high.b + 80);
}

TEST(ColourScale, EveryDecadeOfErrorsIsAsWide) {
    const ColourScale scale = ColourScale::logarithmic(1e-7, 1);
    EXPECT_NEAR(scale.share(1e-6) - scale.share(1e-7), scale.share(1) - scale.share(0.1), 1e-12);
    EXPECT_DOUBLE_EQ(scale.share(0), 0) << "no error at all has a colour, too";
    const auto ticks = scale.ticks();
    ASSERT_EQ(ticks.size(), 8u);
    EXPECT_EQ(ticks.front().text, "1e-7");
    EXPECT_EQ(ticks.back().text, "1");
    EXPECT_DOUBLE_EQ(ticks.back().share, 1);
}

TEST(ColourScale, WhatLiesOutsideHasTheEndsColour) {
    const ColourScale heat = ColourScale::heat(10);
    EXPECT_EQ(heat.colour(1e9), heat.colour(10));
    EXPECT_EQ(heat.colour(-5), heat.colour(0));
    EXPECT_EQ(heat.colour(std::numeric_limits<double>::infinity()), heat.colour(10));
    EXPECT_EQ(heat.colour(std::numeric_limits<double>::quiet_NaN()), heat.colour(0));
    EXPECT_EQ(ColourScale::heat(0).colour(0), heat.colour(0)) << "a scale without extent";
}

TEST(ColourScale, LimitsAreRoundAndNotBelowWhatTheyHold) {
    EXPECT_DOUBLE_EQ(round_limit(0.17), 0.2);
    EXPECT_DOUBLE_EQ(round_limit(0.2), 0.2);
    EXPECT_DOUBLE_EQ(round_limit(21), 50);
    EXPECT_DOUBLE_EQ(round_limit(7e-9), 1e-8);
    EXPECT_DOUBLE_EQ(round_limit(0), 1);
    EXPECT_DOUBLE_EQ(round_limit(std::numeric_limits<double>::quiet_NaN()), 1);
    for (double value = 1e-6; value < 1e6; value *= 1.7) {
        EXPECT_GE(round_limit(value) * (1 + 1e-9), value);
        EXPECT_LE(round_limit(value), 2.5 * value * (1 + 1e-9));
    }
}

TEST(ColourScale, NormalsShowTheirAxes) {
    EXPECT_EQ(normal_colour({1, 0, 0}), (Rgb{255, 128, 128}));
    EXPECT_EQ(normal_colour({0, -1, 0}), (Rgb{128, 0, 128}));
    EXPECT_EQ(normal_colour({0, 0, 1}), (Rgb{128, 128, 255}));
}

}  // namespace
}  // namespace relievo::gui::colour_scale_test
