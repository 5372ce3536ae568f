// The triforce: every part of a half is visited once, whatever the order, and no height leaves the bounds of
// the part it lies in, at every depth.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "renderer/procedural/evaluate.h"
#include "tests/procedural/exemplars.h"

namespace relievo::triforce_test {
namespace {

using glm::dvec2;
using glm::ivec2;
using procedural_double::Triforce;

// What 16 bits tell apart, by far.
constexpr double kRounding = 2e-6;

TEST(Triforce, visits_every_part_of_both_halves_once_in_any_order) {
    constexpr int kRange = 8;
    for (const dvec2 direction : {dvec2(1, 0), dvec2(-1, 0.3), dvec2(0.2, -2), dvec2(-1, -1), dvec2(0, 0)}) {
        const int order = procedural_double::part_order(direction);
        for (const int size : {kRange, -kRange}) {
            const Triforce root{ivec2(size > 0 ? 0 : kRange), size};
            std::set<std::array<int, 3>> visited;
            Triforce t = root;
            bool more = true;
            while (more) {
                while (std::abs(t.size) > 1) t = procedural_double::triforce_down(t, order);
                EXPECT_TRUE(visited.insert({t.base.x, t.base.y, t.size}).second);
                more = procedural_double::triforce_next(order, kRange, t);
            }
            EXPECT_EQ(visited.size(), static_cast<std::size_t>(kRange * kRange));
            EXPECT_EQ(t.base, root.base);
            EXPECT_EQ(t.size, root.size);
        }
    }
}

TEST(Triforce, visits_parts_in_the_order_of_a_direction) {
    const int order = procedural_double::part_order({1, 0.1});
    const Triforce root{{0, 0}, 8}, on_its_head{{8, 8}, -8};
    EXPECT_EQ(procedural_double::triforce_down(root, order).base, ivec2(0, 0));
    EXPECT_EQ(procedural_double::triforce_down(on_its_head, order).base, ivec2(4, 8));
}

// Heights are asked for at random places of random parts; `float` is what the device computes.
void check_parts(const Exemplar& exemplar, const Procedural& settings, int rounds) {
    const ProceduralSource source = exemplar.source(settings);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    double slack = 0;
    for (int i = 0; i < rounds; ++i) {
        const ivec2 texel(static_cast<int>(random() % 20000) - 10000,
                          static_cast<int>(random() % 20000) - 10000);
        const auto map = procedural_float::lattice_map(source.data(), texel);
        const ivec2 square(static_cast<int>(random() % 5) - 2, static_cast<int>(random() % 5) - 2);
        const int depth = i % 10,
                  order = procedural_double::part_order({unit(random) - 0.5, unit(random) - 0.5});
        const bool beyond = random() % 2 == 0;
        procedural_float::Triforce t{ivec2(beyond ? 512 : 0), beyond ? -512 : 512};
        for (int k = 0; k < depth; ++k) {
            t = procedural_float::triforce_down(t, order);
            for (unsigned skip = random() % 4; skip > 0; --skip) {
                procedural_float::Triforce next = t;
                if (procedural_float::triforce_next(order, 512, next) &&
                    std::abs(next.size) == std::abs(t.size))
                    t = next;
            }
        }
        const glm::vec2 base = glm::vec2(t.base) / 512.0f;
        const float size = static_cast<float>(t.size) / 512.0f;
        const auto half =
            procedural_float::lattice_half(source.view(), source.data(), map, square, beyond);
        const glm::vec2 bounds =
            procedural_float::triforce_bounds(source.view(), source.data(), map, half, base, size);
        double low = 1, high = 0;
        for (int k = 0; k < 30; ++k) {
            double u = unit(random), v = unit(random);
            if (k % 3 == 0) u = k % 2 == 0 ? 0 : 1 - v;  // on an edge
            if (u + v > 1) u = 1 - u, v = 1 - v;
            const glm::vec2 place = base + size * glm::vec2(u, v) + glm::vec2(square);
            const glm::vec2 at = procedural_float::to_texels(map, place);
            const double value = source.value(dvec2(at) + dvec2(texel));
            low = std::min(low, value);
            high = std::max(high, value);
        }
        ASSERT_GE(low, static_cast<double>(bounds.x) - kRounding)
            << "depth " << depth << " part " << t.base.x << " " << t.base.y << " " << t.size;
        ASSERT_LE(high, static_cast<double>(bounds.y) + kRounding)
            << "depth " << depth << " part " << t.base.x << " " << t.base.y << " " << t.size;
        if (depth >= 5) slack += static_cast<double>(bounds.y - bounds.x) - (high - low);
    }
    testing::Test::RecordProperty("mean_slack_from_depth_5", std::to_string(slack / (rounds / 2)));
}

TEST(TriforceBounds, hold_every_height_at_every_depth) {
    for (const double size : {0.03, 0.25, 0.9}) {
        SCOPED_TRACE(size);
        check_parts(rough_exemplar(64, 48), {{}, 1, {0, 0}, 5, size}, 3000);
    }
    check_parts(rough_exemplar(256, 256), {{}, 1, {0, 0}, 6, 0.25}, 3000);
}

TEST(TriforceBounds, hold_noise_and_two_values) {
    check_parts(noise_exemplar(33, 17), {{}, 1, {0, 0}, 1, 0.25}, 3000);
    check_parts(two_valued_exemplar(64, 64), {{}, 1, {0, 0}, 2, 0.5}, 3000);
}

TEST(TriforceBounds, hold_extreme_settings) {
    constexpr std::uint32_t kMostBits = 4294967295u;
    for (const std::uint32_t seed : {0u, kMostBits})
        for (const double size : {Procedural::kLeastTriangle, 0.25, Procedural::kMostTriangle})
            for (const double scale : {Procedural::kLeastScale, Procedural::kMostScale}) {
                SCOPED_TRACE(testing::Message() << "seed " << seed << ", triangle " << size << ", scale " << scale);
                const Procedural settings{{}, scale, {-Procedural::kMostOffset, Procedural::kMostOffset}, seed, size};
                check_parts(noise_exemplar(9, 16), settings, 300);
                check_parts(constant_exemplar(1, 1, 20000), settings, 60);
                check_parts(constant_exemplar(7, 3, 65535), settings, 60);
            }
}

TEST(TriforceBounds, are_tighter_than_the_whole_sources) {
    const Exemplar exemplar = rough_exemplar(512, 512);
    const ProceduralSource source = exemplar.source({{}, 1, {0, 0}, 6, 0.25});
    const auto map = procedural_double::lattice_map(source.data(), {0, 0});
    double parts = 0, small = 0;
    for (int i = 0; i < 64; ++i) {
        const ivec2 square(i % 8, i / 8);
        const auto half =
            procedural_double::lattice_half(source.view(), source.data(), map, square, false);
        const dvec2 whole =
            procedural_double::triforce_bounds(source.view(), source.data(), map, half, {0, 0}, 1);
        const dvec2 part = procedural_double::triforce_bounds(source.view(), source.data(), map, half,
                                                              {0.25, 0.25}, 1 / 64.0);
        parts += (whole.y - whole.x) / 64;
        small += (part.y - part.x) / 64;
    }
    const double all = source.whole().high - source.whole().low;
    std::printf("mean range of a half %.3f, of a 4096th of it %.3f, of the source %.3f\n", parts, small, all);
    EXPECT_LT(parts, all);
    EXPECT_LT(small, 0.5 * all);
}

}  // namespace
}  // namespace relievo::triforce_test
