// See falloff_curve.h.
#include "brushes/falloff_curve.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace relievo {
namespace {

constexpr std::array kSmooth{CurvePoint{0, 1}, CurvePoint{0.25f, 0.84375f}, CurvePoint{0.5f, 0.5f},
                             CurvePoint{0.75f, 0.15625f}, CurvePoint{1, 0}};

constexpr float kGrid = 1.0f / FalloffCurve::kLeastStep;  // lines a unit

float on_grid(float value) {
    return std::round(value * kGrid) / kGrid;
}

// At the end of two intervals h0 (the end's own) and h1 with the secants d0 and d1.
float end_slope(float h0, float h1, float d0, float d1) {
    const float slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (slope * d0 <= 0) return 0;
    return d0 * d1 <= 0 && std::abs(slope) > 3 * std::abs(d0) ? 3 * d0 : slope;
}

}  // namespace

FalloffCurve::FalloffCurve() : FalloffCurve(kSmooth) {}

FalloffCurve::FalloffCurve(std::span<const CurvePoint> points) {
    if (const auto fault = check(points))
        throw std::invalid_argument("point " + std::to_string(fault->point) + " of the falloff's curve " +
                                    fault->what);
    std::ranges::copy(points, points_.begin());
    count_ = points.size();
}

std::optional<FalloffCurve::Fault> FalloffCurve::check(std::span<const CurvePoint> points) {
    if (points.size() < kFewest || points.size() > kMost)
        return Fault{0, "must be one of " + std::to_string(kFewest) + " to " + std::to_string(kMost)};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto [part, weight] = points[i];
        if (!(weight >= 0 && weight <= 1)) return Fault{i, "must have a weight in [0, 1]"};
        if (i == 0 && part != 0) return Fault{i, "must lie at 0, the middle"};
        if (i > 0 && !(part - points[i - 1].part >= kLeastStep)) {
            std::ostringstream least;
            least << "must lie at least " << kLeastStep << " beyond the one before, at "
                  << points[i - 1].part;
            return Fault{i, least.str()};
        }
        if (i + 1 == points.size() && part != 1) return Fault{i, "must lie at 1, the rim"};
    }
    return std::nullopt;
}

float FalloffCurve::slope(std::size_t point) const {
    const auto length = [&](std::size_t i) { return points_[i + 1].part - points_[i].part; };
    const auto secant = [&](std::size_t i) {
        return (points_[i + 1].weight - points_[i].weight) / length(i);
    };
    const std::size_t last = count_ - 1;
    if (last == 1) return secant(0);
    if (point == 0) return end_slope(length(0), length(1), secant(0), secant(1));
    if (point == last)
        return end_slope(length(last - 1), length(last - 2), secant(last - 1), secant(last - 2));
    const float before = secant(point - 1), behind = secant(point);
    if (before * behind <= 0) return 0;
    const float w0 = 2 * length(point) + length(point - 1), w1 = length(point) + 2 * length(point - 1);
    return (w0 + w1) / (w0 / before + w1 / behind);
}

float FalloffCurve::weight(float part) const {
    std::size_t i = 0;
    while (i + 2 < count_ && part > points_[i + 1].part) ++i;
    const CurvePoint &a = points_[i], &b = points_[i + 1];
    const float length = b.part - a.part, t = std::clamp((part - a.part) / length, 0.0f, 1.0f), s = 1 - t;
    const float cubic = s * s * ((1 + 2 * t) * a.weight + t * length * slope(i)) +
                        t * t * ((1 + 2 * s) * b.weight - s * length * slope(i + 1));
    return std::clamp(cubic, std::min(a.weight, b.weight), std::max(a.weight, b.weight));  // rounding
}

void FalloffCurve::move(std::size_t point, CurvePoint wanted) {
    CurvePoint& moved = points_[point];
    if (!std::isnan(wanted.weight)) moved.weight = on_grid(std::clamp(wanted.weight, 0.0f, 1.0f));
    if (point == 0 || point + 1 == count_ || std::isnan(wanted.part)) return;
    const float low = std::ceil(points_[point - 1].part * kGrid) / kGrid + kLeastStep;
    const float high = std::floor(points_[point + 1].part * kGrid) / kGrid - kLeastStep;
    if (low <= high) moved.part = std::clamp(on_grid(std::clamp(wanted.part, 0.0f, 1.0f)), low, high);
}

std::optional<std::size_t> FalloffCurve::add(float wanted) {
    if (count_ == kMost || !(wanted >= 0 && wanted <= 1)) return std::nullopt;
    const float part = on_grid(wanted);
    for (std::size_t i = 1; i < count_; ++i) {
        const bool fits = part - points_[i - 1].part >= kLeastStep && points_[i].part - part >= kLeastStep;
        if (!fits) continue;
        const CurvePoint added{part, on_grid(weight(part))};
        std::copy_backward(points_.begin() + static_cast<std::ptrdiff_t>(i),
                           points_.begin() + static_cast<std::ptrdiff_t>(count_),
                           points_.begin() + static_cast<std::ptrdiff_t>(count_) + 1);
        points_[i] = added;
        ++count_;
        return i;
    }
    return std::nullopt;
}

void FalloffCurve::remove(std::size_t point) {
    if (point == 0 || point + 1 >= count_) return;
    std::copy(points_.begin() + static_cast<std::ptrdiff_t>(point) + 1,
              points_.begin() + static_cast<std::ptrdiff_t>(count_),
              points_.begin() + static_cast<std::ptrdiff_t>(point));
    points_[--count_] = {};
}

}  // namespace relievo
