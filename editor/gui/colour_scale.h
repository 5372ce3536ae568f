// Numbers as colours: the scales of the views, their colours and the ticks of their colour bars.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace relievo::gui {

struct Rgb {
    std::uint8_t r = 0, g = 0, b = 0;  // sRGB
    bool operator==(const Rgb&) const = default;
};

// The way of all colours: x, y and z in [-1, 1] as red, green and blue.
Rgb normal_colour(const glm::vec3& unit_normal);

struct Tick {
    double share;  // of the bar, [0, 1]
    std::string text;
};

// A stretch of numbers and its colours. NaN and what lies outside get the nearer end's colour (NaN the low
// one's).
class ColourScale {
  public:
    static ColourScale heat(double high);                     // 0 to `high`: dark to bright
    static ColourScale diverging(double limit);               // -limit to limit: blue, white at 0, red
    static ColourScale logarithmic(double low, double high);  // both above 0: dark to bright

    double share(double value) const;  // where it stands on the bar, [0, 1]
    Rgb colour(double value) const { return colour_at(share(value)); }
    Rgb colour_at(double share) const;
    std::vector<Tick> ticks() const;
    double high() const { return high_; }
    bool operator==(const ColourScale&) const = default;

  private:
    enum class Kind { heat, diverging, logarithmic };
    ColourScale(Kind kind, double low, double high) : kind_(kind), low_(low), high_(high) {}

    Kind kind_;
    double low_, high_;
};

// The least of 1, 2 or 5 times a power of ten that is not below `value`; 1 where value is not above 0.
double round_limit(double value);

}  // namespace relievo::gui
