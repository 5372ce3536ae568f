// See image_error.h.
#include "editor/session/compare/image_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace relievo {
namespace {

constexpr int kReach = 5;  // of the window, pixels
constexpr double kDeviation = 1.5;
constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;  // for values in [0, 1]

using Plane = std::vector<double>;

double encoded(double linear) {
    const double v = std::clamp(linear, 0.0, 1.0);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

Plane luma_of(std::span<const float> rgba) {
    Plane luma;
    luma.reserve(rgba.size() / 4);
    for (std::size_t i = 0; i < rgba.size(); i += 4)
        luma.push_back(0.2126 * encoded(static_cast<double>(rgba[i])) +
                       0.7152 * encoded(static_cast<double>(rgba[i + 1])) +
                       0.0722 * encoded(static_cast<double>(rgba[i + 2])));
    return luma;
}

Plane product(const Plane& a, const Plane& b) {
    Plane result(a.size());
    std::transform(a.begin(), a.end(), b.begin(), result.begin(), std::multiplies<>());
    return result;
}

// One axis of the Gaussian window; beyond the border the last pixel repeats.
Plane blurred(const Plane& plane, int width, int height, bool across) {
    std::array<double, 2 * kReach + 1> weights{};
    double sum = 0;
    for (int k = -kReach; k <= kReach; ++k)
        sum += weights[static_cast<std::size_t>(k + kReach)] =
            std::exp(-k * k / (2 * kDeviation * kDeviation));
    Plane result(plane.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double value = 0;
            for (int k = -kReach; k <= kReach; ++k) {
                const int u = across ? std::clamp(x + k, 0, width - 1) : x,
                          v = across ? y : std::clamp(y + k, 0, height - 1);
                value += weights[static_cast<std::size_t>(k + kReach)] *
                         plane[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(u)];
            }
            result[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)] = value / sum;
        }
    return result;
}

double dissimilarity(int width, int height, const Plane& a, const Plane& b) {
    const auto mean = [&](const Plane& plane) {
        return blurred(blurred(plane, width, height, true), width, height, false);
    };
    const Plane ma = mean(a), mb = mean(b), aa = mean(product(a, a)), bb = mean(product(b, b)),
                ab = mean(product(a, b));
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double va = aa[i] - ma[i] * ma[i], vb = bb[i] - mb[i] * mb[i],
                     covariance = ab[i] - ma[i] * mb[i];
        const double similarity = (2 * ma[i] * mb[i] + kC1) * (2 * covariance + kC2) /
                                  ((ma[i] * ma[i] + mb[i] * mb[i] + kC1) * (va + vb + kC2));
        sum += 1 - similarity;
    }
    return std::max(0.0, sum / static_cast<double>(a.size()));
}

}  // namespace

ImageError image_error(int width, int height, std::span<const float> beauty, std::span<const float> truth) {
    double sum = 0;
    for (std::size_t i = 0; i < beauty.size(); ++i) {
        const double difference = static_cast<double>(beauty[i]) - static_cast<double>(truth[i]);
        if (i % 4 != 3) sum += difference * difference;
    }
    return {std::sqrt(sum / (0.75 * static_cast<double>(beauty.size()))),
            dissimilarity(width, height, luma_of(beauty), luma_of(truth))};
}

}  // namespace relievo
