// A falloff drawn by hand: it meets its points, stays between them, and cannot be drawn into nonsense.
#include "brushes/falloff_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "brushes/dab_tools.h"
#include "chart_surface.h"

namespace relievo::falloff_curve_test {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::vector<CurvePoint> random_points(std::mt19937& random) {
    const auto unit = [&] { return static_cast<float>(random() % 65537) / 65536.0f; };
    std::vector<float> parts{0, 1};
    for (std::size_t i = random() % (FalloffCurve::kMost - 1); i > 0; --i) parts.push_back(unit());
    std::ranges::sort(parts);
    std::vector<CurvePoint> points;
    for (const float part : parts) {
        const bool crowded = !points.empty() && part - points.back().part < FalloffCurve::kLeastStep;
        const bool near_rim = part < 1 && 1 - part < FalloffCurve::kLeastStep;
        if (!crowded && !near_rim) points.push_back({part, random() % 4 == 0 ? std::round(unit()) : unit()});
    }
    return points;
}

TEST(FalloffCurve, meets_its_points_and_never_leaves_the_range_of_two_neighbours) {
    std::mt19937 random(3);
    for (int round = 0; round < 300; ++round) {
        const std::vector<CurvePoint> points = random_points(random);
        const FalloffCurve curve(points);
        for (std::size_t i = 0; i < points.size(); ++i)
            ASSERT_NEAR(curve.weight(points[i].part), points[i].weight, 1e-6f);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const auto &a = points[i], &b = points[i + 1];
            float last = a.weight;
            for (int k = 0; k <= 50; ++k) {
                const float weight = curve.weight(a.part + (b.part - a.part) * static_cast<float>(k) / 50.0f);
                ASSERT_GE(weight, std::min(a.weight, b.weight));
                ASSERT_LE(weight, std::max(a.weight, b.weight));
                ASSERT_GE((weight - last) * (b.weight - a.weight), -2e-7f)
                    << "neither up and down between points";
                last = weight;
            }
        }
    }
}

TEST(FalloffCurve, bends_without_kinks_at_inner_points) {
    const FalloffCurve curve(
        std::array{CurvePoint{0, 1}, CurvePoint{0.3f, 0.9f}, CurvePoint{0.6f, 0.2f}, CurvePoint{1, 0}});
    constexpr float kStep = 1e-3f;
    for (const float at : {0.3f, 0.6f}) {
        const float before = (curve.weight(at) - curve.weight(at - kStep)) / kStep;
        const float behind = (curve.weight(at + kStep) - curve.weight(at)) / kStep;
        EXPECT_NEAR(before, behind, 0.03f) << "at " << at;
    }
}

TEST(FalloffCurve, two_points_make_a_line_and_the_standard_one_is_nearly_smooth) {
    const FalloffCurve line(std::array{CurvePoint{0, 1}, CurvePoint{1, 0}});
    Brush smooth;
    for (float x = 0; x <= 1; x += 1.0f / 64) {
        EXPECT_NEAR(line.weight(x), 1 - x, 1e-6f);
        EXPECT_NEAR(FalloffCurve().weight(x), falloff_weight(smooth, x), 0.02f) << x;
    }
}

TEST(FalloffCurve, wrong_points_are_refused_with_the_first_at_fault) {
    using Points = std::vector<CurvePoint>;
    const std::pair<Points, const char*> wrong[] = {
        {{}, "point 0"},
        {{{0, 1}}, "point 0"},
        {Points(9, {0, 1}), "point 0"},
        {{{0, kNaN}, {1, 0}}, "point 0 of the falloff's curve must have a weight in [0, 1]"},
        {{{0, 1}, {kNaN, 1}, {1, 0}}, "point 1"},
        {{{0, 1}, {0.5f, -0.1f}, {1, 0}}, "point 1"},
        {{{0, 1}, {0.5f, 1}, {0.501f, 1}, {1, 0}}, "point 2"},
        {{{0, 1}, {1, 1}, {1, 0}}, "point 2"},
        {{{0.2f, 1}, {1, 0}}, "point 0"},
        {{{0, 1}, {kInfinity, 0}}, "point 1"},
    };
    for (const auto& [points, words] : wrong) {
        try {
            FalloffCurve{points};
            ADD_FAILURE() << words << ": no error";
        } catch (const std::invalid_argument& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with(words)) << error.what();
        }
    }
}

TEST(FalloffCurve, whatever_is_drawn_is_a_curve) {
    std::mt19937 random(5);
    const auto anywhere = [&] {
        const auto kind = random() % 12;
        if (kind == 0) return kNaN;
        if (kind == 1) return kInfinity;
        return static_cast<float>(random()) / 4294967296.0f * 1.4f - 0.2f;
    };
    for (int round = 0; round < 200; ++round) {
        FalloffCurve curve(random_points(random));
        for (int i = 0; i < 40; ++i) {
            const std::size_t count = curve.points().size(), point = random() % count;
            if (random() % 4 == 0) {
                const auto added = curve.add(anywhere());
                ASSERT_EQ(curve.points().size(), count + (added ? 1 : 0));
            } else if (random() % 4 == 0) {
                curve.remove(point);
            } else {
                curve.move(point, {anywhere(), anywhere()});
            }
            ASSERT_FALSE(FalloffCurve::check(curve.points())) << FalloffCurve::check(curve.points())->what;
        }
        EXPECT_EQ(FalloffCurve(curve.points()), curve) << "nothing is left of removed points";
    }
}

TEST(FalloffCurve, the_ends_stay_where_they_are_and_may_have_any_weight) {
    FalloffCurve curve;
    curve.move(0, {0.5f, 0.25f});
    curve.move(4, {0.5f, 0.75f});
    curve.remove(0);
    curve.remove(4);
    ASSERT_EQ(curve.points().size(), 5u);
    EXPECT_EQ(curve.points().front(), (CurvePoint{0, 0.25f}));
    EXPECT_EQ(curve.points().back(), (CurvePoint{1, 0.75f}));
}

TEST(FalloffCurve, a_stroke_has_its_profile_with_hardness) {
    HeightMap map(256, 256);
    const ChartSurface surface(map, {unit_chart(map)}, 0.2f);
    Sculptor sculptor(map, surface);
    Brush brush;
    brush.tool = Tool::level;
    brush.level = 1;
    brush.strength = 1;
    brush.radius = 0.4f;
    brush.hardness = 0.25f;
    brush.falloff = Falloff::custom;
    brush.falloff_curve =
        FalloffCurve(std::array{CurvePoint{0, 0}, CurvePoint{0.5f, 1}, CurvePoint{1, 0.5f}});
    tap(sculptor, surface, brush, {128.5 / 256, 128.5 / 256});
    for (int x = 128; x < 256; ++x) {
        const float part = static_cast<float>(x - 128) / 256.0f / brush.radius;
        const float along = std::max(0.0f, (part - 0.25f) / 0.75f);
        const double weight = part < 1 ? double{brush.falloff_curve.weight(along)} : 0;
        EXPECT_NEAR(map.at(x, 128), 32768 + weight * 32767, 3) << x;
    }
}

}  // namespace
}  // namespace relievo::falloff_curve_test
