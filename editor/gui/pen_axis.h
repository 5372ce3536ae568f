// Which axis of a pointing device is a pen's pressure, and what its values mean: functions of what the
// display says about the device, without a display.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace relievo::gui {

struct PointerAxis {
    int number = 0;            // the display's
    std::string label;         // as the X server's input drivers name it: "Abs X", "Abs Pressure", ...
    double low = 0, high = 0;  // in the device's units; a driver that does not know gives low >= high
    double value = 0;          // now
};

struct PressureAxis {
    int number = 0;
    double low = 0, high = 1;  // finite, low < high
    double value = 1;          // when the device was asked
};

// A pen's "Abs Pressure" comes before a finger's "Abs MT Pressure"; an axis without a range is none.
std::optional<PressureAxis> pressure_axis(std::span<const PointerAxis> axes);

// [0, 1]; 1 for what is not finite.
double pressure_of(double value, const PressureAxis& axis);

// Drivers make two devices of a pen, and name the other end "... eraser" in one spelling or another.
bool is_eraser(std::string_view device_name);

}  // namespace relievo::gui
