// How gestures become dabs by the stroke settings: string, jitter, airbrush, pressure, grab's drag.
#include "editor/session/stroke_settings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>
#include <utility>

#include "editor/session/stroke_input.h"

namespace relievo::stroke_settings_test {
namespace {

constexpr float kPixelsPerUnit = 100;

// Parallel rays down on the plane z = 0 where x >= 0. Barycentrics carry x / 16 and y / 16.
std::vector<PickHit> pick(std::span<const Ray> rays) {
    std::vector<PickHit> hits;
    for (const Ray& ray : rays) {
        PickHit hit;
        hit.hit = ray.origin.x >= 0;
        hit.b1 = ray.origin.x / 16;
        hit.b2 = ray.origin.y / 16;
        hit.position = {ray.origin.x, ray.origin.y, 0};
        hit.distance = 10;
        hits.push_back(hit);
    }
    return hits;
}

// `tilt`: how much the directions of neighbouring pixels differ.
StrokeInput::CameraRay camera(float tilt) {
    return [tilt](double x_px, double y_px) {
        const auto x = static_cast<float>(x_px), y = static_cast<float>(y_px);
        return Ray{{x / kPixelsPerUnit, y / kPixelsPerUnit, 10}, {(x - 500) * tilt, (y - 300) * tilt, -1}};
    };
}

glm::dvec2 place(const Dab& dab) {
    return glm::dvec2(dab.b1, dab.b2) * (16.0 / Dab::kBarycentricOne);
}

struct Hand {
    explicit Hand(const StrokeSettings& settings, Tool tool = Tool::draw, float tilt = 1e-7f)
        : input(
              brush(tool), pick, camera(tilt), [this](const Dab& dab) { dabs.push_back(dab); }, settings) {}
    static Brush brush(Tool tool) {
        Brush brush;
        brush.tool = tool;
        brush.radius = 0.5f;
        brush.spacing = 0.2f;
        return brush;
    }
    std::vector<Dab> dabs;
    StrokeInput input;
};

TEST(StrokeSettings, AStringLagsAndCutsCorners) {
    StrokeSettings settings;
    settings.lazy_px = 50;
    Hand hand(settings);
    hand.input.begin({0, 100, 100, 1});
    for (std::uint64_t i = 1; i <= 100; ++i)
        hand.input.move({i * 1000, 100 + 3.0 * static_cast<double>(i), 100, 1});
    EXPECT_NEAR(place(hand.dabs.back()).x, 3.5, 0.12) << "half a unit behind 4";
    const std::size_t before = hand.dabs.size();
    for (int i = 0; i < 20; ++i) hand.input.move({200000, 400.0 + i % 3, 100.0 + i % 5 * 2, 1});
    EXPECT_LE(hand.dabs.size(), before + 1) << "a trembling hand on a slack string";
}

TEST(StrokeSettings, JitterStraysWithinItsReachAndRepeats) {
    StrokeSettings settings;
    settings.jitter = 0.5f;
    std::vector<Dab> first;
    for (const std::uint32_t seed : {1u, 1u, 2u}) {
        settings.seed = seed;
        Hand hand(settings, Tool::draw, 1e-3f);  // as wide as the pixels are apart on the plane
        hand.input.begin({0, 100, 300, 1});
        hand.input.end({1000, 900, 300, 1});
        double farthest = 0;
        for (const Dab& dab : hand.dabs) farthest = std::max(farthest, std::abs(place(dab).y - 3));
        EXPECT_GT(farthest, 0.12);
        EXPECT_LT(farthest, 0.3);
        if (first.empty())
            first = hand.dabs;
        else
            EXPECT_EQ(hand.dabs == first, seed == 1u);
    }
}

TEST(StrokeSettings, AirbrushCountsTheClockWhateverTheFrameRate) {
    StrokeSettings settings;
    settings.rate = 50;
    std::vector<Dab> wanted;
    for (const std::uint64_t frame_us : {7000u, 16667u, 200000u}) {
        Hand hand(settings);
        hand.input.begin({1000000, 100, 100, 1});
        std::uint64_t next_frame = frame_us;
        for (std::uint64_t t = 4000; t <= 400000; t += 4000) {
            // Frames between events let the airbrush rest.
            for (; next_frame < t; next_frame += frame_us) hand.input.rest(1000000 + next_frame);
            hand.input.move({1000000 + t, 100 + static_cast<double>(t) / 2000, 100, 1});
        }
        hand.input.rest(1000000 + 1000000);
        hand.input.end({1000000 + 1000000, 300, 100, 1});
        EXPECT_EQ(hand.dabs.size(), 51u) << "one a fiftieth of a second, for a second";
        if (wanted.empty()) wanted = hand.dabs;
        EXPECT_EQ(hand.dabs, wanted) << frame_us;
    }
    EXPECT_EQ(wanted[10].time_us, 200000u);
    EXPECT_NEAR(place(wanted[10]).x, 2.0, 0.05);
}

TEST(StrokeSettings, PressureMakesSizeAndStrengthAsMuchAsAsked) {
    StrokeSettings settings;
    settings.size_by_pressure = 0.5f;
    settings.strength_by_pressure = 0;
    Hand hand(settings);
    hand.input.begin({0, 100, 100, 0.5});
    hand.input.end({1000, 500, 100, 0.5});
    EXPECT_EQ(hand.dabs[0].pressure, Dab::kPressureOne);
    EXPECT_NEAR(hand.dabs[0].size, 0.75 * Dab::kSizeOne, 1);
    EXPECT_NEAR(place(hand.dabs[1]).x - place(hand.dabs[0]).x, 0.075, 1e-3) << "spacing follows the size";
}

TEST(StrokeSettings, TheCurveBendsPressureBetweenItsEndsOnly) {
    StrokeSettings settings;
    settings.pressure_curve = 2;
    for (const auto& [pressure, felt] : {std::pair{0.0, 0.0}, {0.5, 0.25}, {1.0, 1.0}, {7.0, 1.0}}) {
        Hand hand(settings);
        hand.input.begin({0, 100, 100, pressure});
        EXPECT_EQ(hand.dabs[0].pressure, std::lround(felt * Dab::kPressureOne)) << pressure;
    }
}

TEST(StrokeSettings, AnAirbrushAtRestFeelsThePenPressedHarder) {
    StrokeSettings settings;
    settings.rate = 100;
    Hand hand(settings);
    hand.input.begin({0, 100, 100, 0.25});
    hand.input.move({15000, 100, 100, 0.75});
    hand.input.rest(25000);
    ASSERT_EQ(hand.dabs.size(), 3u);
    EXPECT_EQ(hand.dabs[1].pressure, std::lround(0.25 * Dab::kPressureOne));
    EXPECT_EQ(hand.dabs[2].pressure, std::lround(0.75 * Dab::kPressureOne));
}

TEST(StrokeSettings, WhatGrabHasDrawnStaysWhenThePenIsLifted) {
    Hand hand({}, Tool::grab);
    hand.input.begin({0, 100, 100, 0.25});
    hand.input.move({1000, 200, 100, 0.75});
    hand.input.end({2000, 260, 100, 0});
    ASSERT_EQ(hand.dabs.size(), 3u);
    EXPECT_EQ(hand.dabs.back().pressure, std::lround(0.75 * Dab::kPressureOne));
}

TEST(StrokeSettings, GrabStaysAndCarriesTheDragToTheLastPixel) {
    Hand hand({}, Tool::grab);
    hand.input.begin({0, 100, 100, 1});
    for (std::uint64_t i = 1; i < 40; ++i)
        hand.input.move({i * 1000, 100 + 5.0 * static_cast<double>(i), 100, 1});
    hand.input.end({50000, 303, 100, 1});
    ASSERT_GT(hand.dabs.size(), 10u);
    for (const Dab& dab : hand.dabs) EXPECT_NEAR(place(dab).x, 1, 1e-3);
    EXPECT_EQ(hand.dabs.front().drag, (std::array<std::int32_t, 3>{}));
    EXPECT_NEAR(hand.dabs.back().drag[0] / double{Dab::kDragOne} * 0.5, 2.03, 0.05);
    EXPECT_NEAR(hand.dabs.back().drag[2], 0, 400) << "in the plane across the view";
    Hand beside({}, Tool::grab);
    beside.input.begin({0, -100, 100, 1});
    beside.input.end({1000, 300, 100, 1});
    EXPECT_TRUE(beside.dabs.empty()) << "nothing was taken hold of";
}

TEST(StrokeSettings, ValuesOutOfRangeAreRejectedByName) {
    for (const StrokeParameter& parameter : stroke_parameters())
        for (const float bad :
             {parameter.low - 1, parameter.high * 2 + 1, std::numeric_limits<float>::quiet_NaN()}) {
            StrokeSettings settings;
            settings.*parameter.value = bad;
            try {
                Hand hand(settings);
                ADD_FAILURE() << parameter.name;
            } catch (const std::invalid_argument& error) {
                EXPECT_NE(std::string(error.what()).find(parameter.name), std::string::npos) << error.what();
            }
        }
}

}  // namespace
}  // namespace relievo::stroke_settings_test
