// See pen_axis.h.
#include "editor/gui/pen_axis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace relievo::gui {

std::optional<PressureAxis> pressure_axis(std::span<const PointerAxis> axes) {
    constexpr std::array<std::string_view, 2> kLabels{"Abs Pressure", "Abs MT Pressure"};
    for (const std::string_view label : kLabels)
        for (const PointerAxis& axis : axes) {
            const bool ranged = std::isfinite(axis.low) && std::isfinite(axis.high) && axis.low < axis.high;
            if (axis.label == label && ranged)
                return PressureAxis{axis.number, axis.low, axis.high, axis.value};
        }
    return std::nullopt;
}

double pressure_of(double value, const PressureAxis& axis) {
    if (!std::isfinite(value)) return 1;
    // Halved first: the range of two finite numbers may be none.
    return std::clamp((value / 2 - axis.low / 2) / (axis.high / 2 - axis.low / 2), 0.0, 1.0);
}

bool is_eraser(std::string_view device_name) {
    constexpr std::string_view kWord = "eraser";
    const auto same = [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b); };
    return std::search(device_name.begin(), device_name.end(), kWord.begin(), kWord.end(), same) !=
           device_name.end();
}

}  // namespace relievo::gui
