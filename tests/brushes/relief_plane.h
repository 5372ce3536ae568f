// A flat surface whose right answer is known, and what is done to it, for the tests of tools that shape relief.
#pragma once

#include <cmath>

#include "chart_surface.h"

namespace relievo {

inline constexpr float kAmplitude = 0.2f;

struct Plane {
    explicit Plane(int size = 256, std::uint16_t count = 32768, float amplitude = kAmplitude)
        : map(size, size, count), surface(map, {unit_chart(map)}, amplitude), sculptor(map, surface) {}
    int at(double x, double y) const {
        return map.at(static_cast<int>(x * map.width()), static_cast<int>(y * map.height()));
    }

    HeightMap map;
    ChartSurface surface;
    Sculptor sculptor;
};

inline Brush brush_of(Tool tool, float radius = 0.1f, float strength = 1.0f) {
    Brush brush;
    brush.tool = tool;
    brush.radius = radius;
    brush.strength = strength;
    return brush;
}

inline double bump(double x, double y, double width) {
    return std::exp(-(x * x + y * y) / (width * width));
}

}  // namespace relievo
