// Range reduction and Taylor series; see the header for why these are not the C library's.
#include "assets/generator/portable_math.h"

#include <cmath>

namespace relievo::assets {
namespace {

// pi / 2 in two parts: the first has its low 20 bits clear, so that multiples of it are exact.
constexpr double kHalfPiHigh = 1.570796326734125614166;
constexpr double kHalfPiLow = 6.077100506506192601e-11;

double sine_near_zero(double x) {
    const double z = x * x;
    double sum = 1.0;
    for (int n = 17; n >= 3; n -= 2) sum = 1.0 - z / static_cast<double>(n * (n - 1)) * sum;
    return x * sum;
}

double cosine_near_zero(double x) {
    const double z = x * x;
    double sum = 1.0;
    for (int n = 18; n >= 2; n -= 2) sum = 1.0 - z / static_cast<double>(n * (n - 1)) * sum;
    return sum;
}

// The sine of `radians` plus `quarter_turns` times pi / 2.
double sine_turned(double radians, int quarter_turns) {
    const double turns = std::floor(radians / (kPi / 2) + 0.5);
    const double rest = (radians - turns * kHalfPiHigh) - turns * kHalfPiLow;
    const int quadrant = (static_cast<int>(turns - 4.0 * std::floor(turns / 4.0)) + quarter_turns) & 3;
    const double value = (quadrant & 1) ? cosine_near_zero(rest) : sine_near_zero(rest);
    return (quadrant & 2) ? -value : value;
}

// For |x| <= 1: three halvings of the angle bring it under 0.1, where the series is short.
double arc_tangent_of_ratio(double x) {
    for (int i = 0; i < 3; ++i) x = x / (1.0 + std::sqrt(1.0 + x * x));
    const double z = x * x;
    double sum = 0.0;
    for (int n = 17; n >= 1; n -= 2) sum = 1.0 / static_cast<double>(n) - z * sum;
    return 8.0 * x * sum;
}

}  // namespace

double sine(double radians) {
    return sine_turned(radians, 0);
}
double cosine(double radians) {
    return sine_turned(radians, 1);
}
double tangent(double radians) {
    return sine(radians) / cosine(radians);
}

double arc_tangent(double y, double x) {
    if (x == 0.0 && y == 0.0) return 0.0;
    if (std::fabs(y) > std::fabs(x)) {
        const double rest = arc_tangent_of_ratio(x / y);
        return y > 0.0 ? kPi / 2 - rest : -kPi / 2 - rest;
    }
    const double angle = arc_tangent_of_ratio(y / x);
    if (x > 0.0) return angle;
    return y >= 0.0 ? angle + kPi : angle - kPi;
}

double exponential(double x) {
    if (x < -700.0) return 0.0;
    constexpr double kLn2 = 0.69314718055994530942;
    const double power = std::floor(x / kLn2 + 0.5);
    const double rest = x - power * kLn2;
    double sum = 1.0;
    for (int n = 14; n >= 1; --n) sum = 1.0 + rest / static_cast<double>(n) * sum;
    return std::ldexp(sum, static_cast<int>(power));
}

double clamp01(double x) {
    return x < 0.0 ? 0.0 : x > 1.0 ? 1.0 : x;
}
double mix(double a, double b, double t) {
    return a + (b - a) * t;
}

double smooth_step(double low, double high, double x) {
    const double t = clamp01((x - low) / (high - low));
    return t * t * (3.0 - 2.0 * t);
}

double dome(double x) {
    const double rest = 1.0 - x * x;
    return rest > 0.0 ? rest * rest : 0.0;
}

}  // namespace relievo::assets
