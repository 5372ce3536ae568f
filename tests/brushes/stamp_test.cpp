// The stamp: images pressed into flat surfaces, whole and cut, against their closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "brushes/dab_tools.h"
#include "chart_surface.h"

namespace relievo::stamp_test {
namespace {

constexpr float kAmplitude = 0.2f, kRadius = 0.2f;
constexpr double kFull = double{kDrawRise} * double{kRadius} / double{kAmplitude} * 65535;  // counts

// An image of a smooth function on [-1, 1]^2.
template <typename Value>
std::shared_ptr<const Alpha> painted(int width, int height, Value value) {
    std::vector<float> values;
    const double longer = std::max(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            values.push_back(
                static_cast<float>(value((2.0 * x + 1 - width) / longer, (2.0 * y + 1 - height) / longer)));
    return std::make_shared<const Alpha>("painted", width, height, std::move(values));
}

// What neither bilinear filtering nor halving the image changes, but at its border.
double hills(double x, double y) {
    return 0.5 + 0.2 * x + 0.1 * y + 0.15 * x * y;
}

Brush stamp_brush() {
    Brush brush;
    brush.tool = Tool::stamp;
    brush.falloff = Falloff::constant;
    brush.radius = kRadius;
    brush.strength = 1.0f;
    return brush;
}

struct Plane {
    explicit Plane(int size = 256)
        : map(size, size), surface(map, {unit_chart(map)}, kAmplitude), sculptor(map, surface) {}

    void press(const Brush& brush, std::shared_ptr<const Alpha> alpha, glm::dvec2 at, glm::dvec3 right = {}) {
        sculptor.begin(brush, std::move(alpha));
        dab(at, right);
        sculptor.end();
    }
    void dab(glm::dvec2 at, glm::dvec3 right = {}) {
        Dab dab = surface.dab(at.x, at.y);
        for (int k = 0; k < 3; ++k)
            dab.drag[static_cast<std::size_t>(k)] =
                static_cast<std::int32_t>(std::lround(right[k] * Dab::kDragOne));
        sculptor.dab(dab);
    }
    // The largest difference to 32768 + `rise` (counts, of the place over the radius from `at`) in the ball.
    template <typename Rise>
    double largest_error(glm::dvec2 at, Rise rise) const {
        double largest = 0;
        for (int y = 0; y < map.height(); ++y)
            for (int x = 0; x < map.width(); ++x) {
                const glm::dvec2 p =
                    (glm::dvec2(x + 0.5, y + 0.5) / double(map.width()) - at) / double{kRadius};
                if (glm::length(p) >= 0.96) continue;
                largest = std::max(largest, std::abs(map.at(x, y) - 32768 - rise(p)));
            }
        return largest;
    }

    HeightMap map;
    ChartSurface surface;
    Sculptor sculptor;
};

TEST(Stamp, one_press_raises_by_the_image_to_a_count) {
    Plane plane;
    plane.press(stamp_brush(), painted(512, 512, hills), {0.5, 0.5});
    EXPECT_LE(plane.largest_error({0.5, 0.5}, [](glm::dvec2 p) { return kFull * hills(p.x, p.y); }), 1.0);
    EXPECT_EQ(plane.map.at(10, 10), 32768);
}

TEST(Stamp, strength_pressure_falloff_and_invert_scale_it) {
    Plane plane;
    Brush brush = stamp_brush();
    brush.falloff = Falloff::smooth;
    brush.strength = 0.5f;
    brush.invert = true;
    plane.press(brush, painted(512, 512, hills), {0.5, 0.5});
    const auto expected = [&](glm::dvec2 p) {
        const float falloff = falloff_weight(brush, static_cast<float>(glm::length(p)));
        return -0.5 * kFull * hills(p.x, p.y) * double{falloff};
    };
    EXPECT_LE(plane.largest_error({0.5, 0.5}, expected), 1.0);
}

TEST(Stamp, rotation_turns_it_anticlockwise_and_the_hand_says_where_its_right_is) {
    const double angle = 30 * 3.14159265358979323846 / 180;
    const auto turned = [&](glm::dvec2 p) {
        return kFull * hills(std::cos(angle) * p.x + std::sin(angle) * p.y,
                             std::cos(angle) * p.y - std::sin(angle) * p.x);
    };
    Plane by_setting, by_hand;
    Brush brush = stamp_brush();
    by_hand.press(brush, painted(512, 512, hills), {0.5, 0.5}, {std::cos(angle), std::sin(angle), 0.3});
    brush.rotation = 30;
    by_setting.press(brush, painted(512, 512, hills), {0.5, 0.5});
    EXPECT_LE(by_setting.largest_error({0.5, 0.5}, turned), 1.0);
    EXPECT_LE(by_hand.largest_error({0.5, 0.5}, turned), 1.0);
}

TEST(Stamp, presses_add_up_and_without_accumulate_the_highest_counts) {
    Plane added, once;
    Brush brush = stamp_brush();
    brush.strength = 0.3f;
    const auto alpha = painted(64, 64, [](double, double) { return 1.0; });
    for (Plane* plane : {&added, &once}) {
        brush.accumulate = plane == &added;
        plane->sculptor.begin(brush, alpha);
        for (int i = 0; i < 3; ++i) plane->dab({0.45 + 0.05 * i, 0.5});
        plane->sculptor.end();
    }
    EXPECT_NEAR(added.map.at(128, 128) - 32768, 3 * 0.3 * kFull, 1);
    EXPECT_NEAR(once.map.at(128, 128) - 32768, 0.3 * kFull, 1);
}

TEST(Stamp, raised_ground_does_not_bend_the_image) {
    Plane plane;
    fill(plane.map, [](int x, int) { return 20000 + 40.0 * x; });
    const HeightMap before = plane.map;
    plane.press(stamp_brush(), painted(512, 512, hills), {0.5, 0.5});
    for (int x = 100; x < 156; x += 5) {
        const double place = ((x + 0.5) / 256 - 0.5) / double{kRadius}, across = 0.5 / 256 / double{kRadius};
        EXPECT_NEAR(plane.map.at(x, 128) - before.at(x, 128), kFull * hills(place, across), 1.5) << x;
    }
}

TEST(Stamp, a_wide_image_keeps_its_shape_and_one_pixel_is_a_square) {
    Plane wide, one;
    wide.press(stamp_brush(), painted(64, 32, [](double, double) { return 1.0; }), {0.5, 0.5});
    EXPECT_NEAR(wide.map.at(128, 128 + 24) - 32768, kFull, 1) << "0.47 of the radius";
    EXPECT_EQ(wide.map.at(128, 128 + 27), 32768) << "0.53 of the radius";
    EXPECT_NEAR(wide.map.at(128 + 48, 128) - 32768, kFull, 1);
    one.press(stamp_brush(), painted(1, 1, [](double, double) { return 0.5; }), {0.5, 0.5});
    EXPECT_LE(one.largest_error({0.5, 0.5}, [](glm::dvec2) { return 0.5 * kFull; }), 1.0);
}

TEST(Stamp, fine_patterns_under_a_small_brush_become_their_mean) {
    Plane plane(64);  // 13 texels to the radius
    const auto checks = std::make_shared<const Alpha>("checks", 1024, 1024, [] {
        std::vector<float> values;
        for (int i = 0; i < 1024 * 1024; ++i) values.push_back(static_cast<float>((i + i / 1024) % 2));
        return values;
    }());
    plane.press(stamp_brush(), checks, {0.5, 0.5});
    EXPECT_LE(plane.largest_error({0.5, 0.5}, [](glm::dvec2) { return 0.5 * kFull; }), 1.0);
}

// The unit square cut at x = 0.5: the left half upright, the right one turned by a quarter and at 1.5 times
// the scale.
TEST(Stamp, over_islands_of_other_turn_and_scale_it_goes_on_unbroken) {
    HeightMap map(256, 256);
    const ChartSurface surface(
        map,
        {{{0, 0}, {0.5, 1}, {2, 0}, {96, 0}, {0, 96}}, {{0.5, 0}, {1, 1}, {230, 20}, {0, 144}, {-144, 0}}},
        kAmplitude);
    Sculptor sculptor(map, surface);
    sculptor.begin(stamp_brush(), painted(512, 512, hills));
    sculptor.dab(surface.dab(0.47, 0.5));
    sculptor.end();
    double largest = 0;
    std::vector<SurfaceTexel> texels;
    surface.texels_in_ball({0.47f, 0.5f, 0.0f}, 0.18f, texels);
    ASSERT_GT(texels.size(), 500u);
    for (const SurfaceTexel& texel : texels) {
        const glm::dvec2 p = (glm::dvec2(texel.position) - glm::dvec2(0.47, 0.5)) / double{kRadius};
        largest = std::max(largest, std::abs(map.at(texel.x, texel.y) - 32768 - kFull * hills(p.x, p.y)));
    }
    EXPECT_LE(largest, 2.0) << "both sides follow one closed form";
}

TEST(Stamp, without_an_image_it_is_refused) {
    Plane plane(16);
    EXPECT_THROW(plane.sculptor.begin(stamp_brush()), std::invalid_argument);
    EXPECT_FALSE(plane.sculptor.in_stroke());
}

}  // namespace
}  // namespace relievo::stamp_test
