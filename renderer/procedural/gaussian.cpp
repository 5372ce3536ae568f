// See gaussian.h.
#include "renderer/procedural/gaussian.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace relievo {
namespace {

constexpr double kMean = 0.5, kDeviation = 1.0 / 6;

double untruncated(double g) {
    return 0.5 * std::erfc((kMean - g) / (kDeviation * std::numbers::sqrt2));
}

}  // namespace

double gaussian_share(double g) {
    const double below = untruncated(0), all = 1 - 2 * below;
    return std::clamp((untruncated(g) - below) / all, 0.0, 1.0);
}

// Halving: the share rises steadily, and 60 halvings leave nothing of [0, 1].
double gaussian_value(double share) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (gaussian_share(middle) < share ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace relievo
