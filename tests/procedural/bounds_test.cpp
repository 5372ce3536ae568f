// No sampled height leaves its bounds, in either precision; the soft clipping rises as the bounds rely on.
#include <gtest/gtest.h>

#include <random>

#include "renderer/procedural/evaluate.h"
#include "tests/procedural/exemplars.h"

namespace relievo::bounds_test {
namespace {

using glm::dvec2;
using glm::ivec2;

// What 16 bits tell apart, by far.
constexpr double kRounding = 2e-6;

TEST(SoftClip, rises_with_the_mean_and_turns_towards_the_ends_as_deviations_shrink) {
    using procedural_double::soft_clip;
    for (int i = 0; i <= 200; ++i) {
        for (int j = 0; j < 200; ++j) {
            const double x = i / 200.0, w = 0.57735 + j * (1 - 0.57735) / 200, more = w + (1 - 0.57735) / 200;
            const double at = soft_clip(x, w);
            EXPECT_GE(at, 0);
            EXPECT_LE(at, 1);
            EXPECT_LE(at, soft_clip(std::min(x + 1 / 200.0, 1.0), w) + 1e-12) << x << " " << w;
            const double turn = soft_clip(x, more) - at;
            EXPECT_GE(x <= 0.5 ? turn : -turn, -1e-12) << x << " " << w;
        }
    }
    EXPECT_DOUBLE_EQ(soft_clip(0.3, 1), 0.3);  // one piece alone stays what it is
}

void check_squares(const Exemplar& exemplar, const Procedural& settings, int rounds) {
    const ProceduralSource source = exemplar.source(settings);
    std::mt19937 random(3);
    double slack = 0;
    for (int i = 0; i < rounds; ++i) {
        const int side = 1 << (random() % 6);
        const ivec2 first(static_cast<int>(random() % 200000) - 100000,
                          static_cast<int>(random() % 200000) - 100000);
        const ivec2 extent(1 + static_cast<int>(random()) % side, 1 + static_cast<int>(random()) % side);
        const ivec2 reach = glm::abs(extent) + 1;
        const auto bounds = source.range(first, first + reach);
        const glm::vec2 shipped = procedural_float::procedural_bounds(source.view(), first, reach);
        double low = 1, high = 0;
        for (int k = 0; k < 40; ++k) {
            const ivec2 at = first + ivec2(static_cast<int>(random() % static_cast<unsigned>(reach.x + 1)),
                                           static_cast<int>(random() % static_cast<unsigned>(reach.y + 1)));
            const double value = source.texel(at);
            const glm::vec4 quad = procedural_float::procedural_quad(source.view(), at);
            low = std::min(low, value);
            high = std::max(high, value);
            ASSERT_GE(static_cast<double>(quad.x), static_cast<double>(shipped.x) - kRounding);
            ASSERT_LE(static_cast<double>(quad.x), static_cast<double>(shipped.y) + kRounding);
        }
        ASSERT_GE(low, bounds.low - kRounding)
            << first.x << " " << first.y << " " << reach.x << " " << reach.y;
        ASSERT_LE(high, bounds.high + kRounding)
            << first.x << " " << first.y << " " << reach.x << " " << reach.y;
        ASSERT_GE(bounds.low, source.whole().low - kRounding);
        ASSERT_LE(bounds.high, source.whole().high + kRounding);
        slack += bounds.high - bounds.low - (high - low);
    }
    testing::Test::RecordProperty("mean_slack", std::to_string(slack / rounds));
}

TEST(ProceduralBounds, hold_every_texel_of_rectangles) {
    for (const double size : {0.001, 0.03, 0.25, 3.0, 1000.0}) {
        SCOPED_TRACE(size);
        check_squares(rough_exemplar(64, 48), {{}, 1, {0, 0}, 5, size}, 1500);
    }
}

TEST(ProceduralBounds, hold_noise_and_two_values_and_single_texels) {
    check_squares(noise_exemplar(33, 17), {{}, 1, {0, 0}, 1, 0.25}, 1500);
    check_squares(two_valued_exemplar(16, 16), {{}, 1, {0, 0}, 2, 0.5}, 1500);
    check_squares(constant_exemplar(1, 1, 20000), {{}, 1, {0, 0}, 3, 0.25}, 200);
}

TEST(ProceduralBounds, hold_the_surface_over_triangles) {
    const Exemplar exemplar = rough_exemplar(64, 64);
    const ProceduralSource source = exemplar.source({{}, 2.5, {3.25, -7}, 9, 0.25});
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-2, 2), unit(0, 1);
    double loose = 0;
    for (int i = 0; i < 300; ++i) {
        const dvec2 corner(place(random), place(random));
        const double size = std::pow(10.0, -3 * unit(random));
        const auto near = [&] { return corner + size * dvec2(unit(random), unit(random)); };
        const std::array<dvec2, 3> uv{near(), near(), near()};
        const auto bounds = source.range(uv);
        double low = 1, high = 0;
        for (int k = 0; k < 200; ++k) {
            double a = unit(random), b = unit(random);
            if (a + b > 1) a = 1 - a, b = 1 - b;
            const double value =
                source.value(source.texel_at(uv[0] + a * (uv[1] - uv[0]) + b * (uv[2] - uv[0])));
            low = std::min(low, value);
            high = std::max(high, value);
        }
        ASSERT_GE(low, bounds.low - kRounding);
        ASSERT_LE(high, bounds.high + kRounding);
        loose += (bounds.high - bounds.low) - (high - low);
    }
    EXPECT_LT(loose / 300, 0.35);
}

}  // namespace
}  // namespace relievo::bounds_test
