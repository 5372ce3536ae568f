// The source looks like its exemplar and repeats nowhere.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "renderer/procedural/evaluate.h"
#include "renderer/procedural/gaussian.h"
#include "tests/procedural/exemplars.h"

namespace relievo::statistics_test {
namespace {

using glm::ivec2;

TEST(Gaussianised, fills_zero_to_one_with_mean_a_half_and_deviation_a_sixth) {
    const ProceduralSource source = rough_exemplar(256, 256).source({});
    double sum = 0, square = 0;
    for (const std::uint16_t v : source.gaussianised()) {
        sum += v / 65535.0;
        square += v / 65535.0 * (v / 65535.0);
    }
    const double count = static_cast<double>(source.gaussianised().size()), mean = sum / count;
    EXPECT_NEAR(mean, 0.5, 1e-3);
    // Truncated at three deviations, a Gaussian's own deviation is 0.9866 of what it was.
    EXPECT_NEAR(std::sqrt(square / count - mean * mean), 0.9866 / 6, 1e-3);
    EXPECT_NEAR(gaussian_share(gaussian_value(0.2)), 0.2, 1e-12);
    EXPECT_EQ(gaussian_share(0), 0);
    EXPECT_EQ(gaussian_share(1), 1);
}

TEST(Gaussianised, the_table_leads_back_to_the_exemplar) {
    const Exemplar exemplar = rough_exemplar(128, 128);
    const ProceduralSource source = exemplar.source({});
    double worst = 0;
    for (std::size_t i = 0; i < exemplar.texels.size(); ++i) {
        const double back = procedural_double::restored(source.view(), source.gaussianised()[i] / 65535.0);
        worst = std::max(worst, std::abs(back - exemplar.texels[i] / 65535.0));
    }
    EXPECT_LT(worst, 4e-3);
}

// Kolmogorov-Smirnov: the greatest difference of the two cumulative histograms. Texels of one lattice
// triangle are alike, so they are taken far apart.
double histogram_distance(const Exemplar& exemplar, const ProceduralSource& source, int count) {
    std::vector<double> have(65536), want(65536);
    for (const std::uint16_t v : exemplar.texels)
        want[v] += 1.0 / static_cast<double>(exemplar.texels.size());
    std::mt19937 random(1);
    for (int i = 0; i < count; ++i) {
        const ivec2 at(static_cast<int>(random() >> 3), static_cast<int>(random() >> 3));
        have[static_cast<std::size_t>(std::lround(source.texel(at) * 65535))] += 1.0 / count;
    }
    double a = 0, b = 0, distance = 0;
    for (std::size_t v = 0; v < 65536; ++v) {
        a += have[v];
        b += want[v];
        distance = std::max(distance, std::abs(a - b));
    }
    return distance;
}

TEST(ProceduralHistogram, of_ten_million_values_is_the_exemplars) {
    const Exemplar exemplar = rough_exemplar(256, 256);
    const double distance =
        histogram_distance(exemplar, exemplar.source({{}, 1, {0, 0}, 4, 0.25}), 10'000'000);
    RecordProperty("kolmogorov_smirnov", std::to_string(distance));
    EXPECT_LT(distance, 0.006);
}

TEST(ProceduralHeights, are_continuous_across_lattice_edges) {
    // A smooth exemplar and large triangles: along texel rows, no step is larger than the steepest inside
    // triangles.
    const Exemplar exemplar = rough_exemplar(256, 256);
    const ProceduralSource source = exemplar.source({{}, 1, {0, 0}, 4, 0.25});
    const gpu::ProceduralData& data = source.data();
    const auto place = [&](const ivec2& at) {
        glm::uvec2 x, y;
        procedural_double::lattice_coordinates(data, at, x, y);
        return procedural_double::lattice_place(x, y);
    };
    double inside = 0, across = 0;
    int crossings = 0;
    for (int row = 0; row < 400; ++row) {
        ivec2 at(-2000, row * 37);
        double last = source.texel(at);
        auto last_place = place(at);
        for (; at.x < -1000; ++at.x) {
            const double value = source.texel(at);
            const auto now = place(at);
            const bool same = procedural_double::same_half(now, last_place);
            crossings += same ? 0 : 1;
            (same ? inside : across) = std::max(same ? inside : across, std::abs(value - last));
            last = value;
            last_place = now;
        }
    }
    EXPECT_GT(crossings, 1000);
    EXPECT_LT(across, 1.05 * inside);
}

TEST(ProceduralHeights, are_independent_of_how_far_the_lattice_is) {
    // Fixed point: a shift by a multiple of what both axes repeat the lattice's fractions in keeps nothing
    // else.
    const ProceduralSource source = noise_exemplar(32, 32).source({{}, 1, {0, 0}, 4, 0.25});
    const gpu::ProceduralData& data = source.data();
    for (const int far : {1 << 20, -(1 << 29)}) {
        glm::uvec2 x0, y0, x1, y1;
        procedural_double::lattice_coordinates(data, {far, far}, x0, y0);
        procedural_double::lattice_coordinates(data, {far + 1, far}, x1, y1);
        EXPECT_EQ(x0, x1);
        EXPECT_EQ(procedural_double::fixed_sum(y0, data.step_yx), y1);
    }
}

TEST(ProceduralHeights, repeat_nowhere) {
    const Exemplar exemplar = rough_exemplar(64, 64);
    const ProceduralSource source = exemplar.source({{}, 1, {0, 0}, 4, 0.25});
    constexpr int kSide = 1024;
    std::vector<double> height(kSide * kSide);
    double mean = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            mean += height[static_cast<std::size_t>(y * kSide + x)] = source.texel({x, y});
    mean /= kSide * kSide;
    const auto correlation = [&](int dx, int dy) {
        double both = 0, one = 0, other = 0;
        for (int y = 0; y + dy < kSide; y += 3) {
            for (int x = 0; x + dx < kSide; x += 3) {
                const double a = height[static_cast<std::size_t>(y * kSide + x)] - mean;
                const double b = height[static_cast<std::size_t>((y + dy) * kSide + x + dx)] - mean;
                both += a * b;
                one += a * a;
                other += b * b;
            }
        }
        return both / std::sqrt(one * other);
    };
    EXPECT_GT(correlation(1, 0), 0.8);  // the exemplar is smooth
    // The exemplar's own period, the lattice's, and whatever else: nothing returns.
    double worst = 0;
    for (int k = 1; k <= 6; ++k)
        for (const auto& [dx, dy] :
             {std::pair{64 * k, 0}, {0, 64 * k}, {64 * k, 64 * k}, {32 * k, 17 * k}, {96 * k, 40 * k}})
            worst = std::max(worst, std::abs(correlation(dx, dy)));
    EXPECT_LT(worst, 0.1);
}

TEST(ProceduralHeights, of_a_constant_exemplar_are_that_constant) {
    const ProceduralSource source = constant_exemplar(5, 3, 12345).source({{}, 1, {0, 0}, 1, 0.7});
    for (int i = 0; i < 1000; ++i) EXPECT_DOUBLE_EQ(source.texel({i * 7, i * 13}), 12345 / 65535.0);
    EXPECT_DOUBLE_EQ(source.whole().low, source.whole().high);
}

}  // namespace
}  // namespace relievo::statistics_test
