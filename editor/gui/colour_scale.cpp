// Numbers as colours.
#include "editor/gui/colour_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace relievo::gui {
namespace {

using Colours = std::array<glm::dvec3, 5>;  // at equal distances

// Brightness rises all the way, so that the order shows without the colours too.
constexpr Colours kHeat{{{14, 11, 34}, {86, 20, 110}, {190, 52, 82}, {248, 146, 20}, {252, 252, 170}}};
constexpr Colours kDiverging{
    {{30, 78, 160}, {128, 182, 222}, {244, 244, 242}, {240, 164, 118}, {170, 28, 40}}};

std::uint8_t byte(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

Rgb between(const Colours& colours, double share) {
    const double place = share * static_cast<double>(colours.size() - 1);
    const auto first = std::min(static_cast<std::size_t>(place), colours.size() - 2);
    const double f = place - static_cast<double>(first);
    const glm::dvec3 c = colours[first] * (1 - f) + colours[first + 1] * f;
    return {byte(c.x), byte(c.y), byte(c.z)};
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string power_of_ten(int exponent) {
    return exponent == 0 ? "1" : "1e" + std::to_string(exponent);
}

}  // namespace

Rgb normal_colour(const glm::vec3& n) {
    const auto channel = [](float part) { return byte(127.5 + 127.5 * static_cast<double>(part)); };
    return {channel(n.x), channel(n.y), channel(n.z)};
}

ColourScale ColourScale::heat(double high) {
    return {Kind::heat, 0, high};
}
ColourScale ColourScale::diverging(double limit) {
    return {Kind::diverging, -limit, limit};
}
ColourScale ColourScale::logarithmic(double low, double high) {
    return {Kind::logarithmic, low, high};
}

double ColourScale::share(double value) const {
    double part = 0;
    if (kind_ == Kind::logarithmic) {
        part = value > 0 ? std::log(value / low_) / std::log(high_ / low_) : 0;
    } else {
        part = (value - low_) / (high_ - low_);
    }
    return std::isnan(part) ? 0 : std::clamp(part, 0.0, 1.0);
}

Rgb ColourScale::colour_at(double share) const {
    return between(kind_ == Kind::diverging ? kDiverging : kHeat, share);
}

std::vector<Tick> ColourScale::ticks() const {
    if (kind_ != Kind::logarithmic) {
        const double middle = (low_ + high_) / 2;
        // A heat map ends below the few largest numbers.
        const std::string end = number(high_) + (kind_ == Kind::heat ? "+" : "");
        return {{0, number(low_)}, {0.5, number(middle)}, {1, end}};
    }
    std::vector<Tick> ticks;
    const int first = static_cast<int>(std::lround(std::log10(low_)));
    const int last = static_cast<int>(std::lround(std::log10(high_)));
    for (int exponent = first; exponent <= last; ++exponent)
        ticks.push_back({share(std::pow(10.0, exponent)), power_of_ten(exponent)});
    return ticks;
}

double round_limit(double value) {
    if (!(value > 0) || !std::isfinite(value)) return 1;
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (value <= step * decade * (1 + 1e-12)) return step * decade;
    return 10 * decade;
}

}  // namespace relievo::gui
