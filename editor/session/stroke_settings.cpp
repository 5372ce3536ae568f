// The table of stroke settings, and the range check that reads it.
#include "editor/session/stroke_settings.h"

#include <array>
#include <stdexcept>
#include <string>

#include "editor/session/text.h"

namespace relievo {
namespace {

constexpr std::array kParameters{
    StrokeParameter{"radius_px", "pixels", "Reach of the brush on the screen", 1.0f, 2000.0f, 40.0f,
                    &StrokeSettings::radius_px},
    StrokeParameter{"radius_texels", "texels", "Reach of the brush in texels of the map", 0.5f, 4000.0f,
                    16.0f, &StrokeSettings::radius_texels},
    StrokeParameter{"jitter", "of the radius", "How far dabs stray from the stroke", 0.0f, 2.0f, 0.0f,
                    &StrokeSettings::jitter},
    StrokeParameter{"lazy_px", "pixels", "The brush follows the pointer on a string so long: steady lines",
                    0.0f, 500.0f, 0.0f, &StrokeSettings::lazy_px},
    StrokeParameter{"rate", "dabs a second", "Airbrush: dabs by time, also at rest; 0 is off", 0.0f, 200.0f,
                    0.0f, &StrokeSettings::rate},
    StrokeParameter{"size_by_pressure", "", "How much the pen's pressure makes the size", 0.0f, 1.0f, 0.0f,
                    &StrokeSettings::size_by_pressure},
    StrokeParameter{"strength_by_pressure", "", "How much the pen's pressure makes the strength", 0.0f, 1.0f,
                    1.0f, &StrokeSettings::strength_by_pressure},
    StrokeParameter{"pressure_curve", "exponent",
                    "The pen's pressure counts to this power: above 1 it starts softly, below 1 it bites at once",
                    0.1f, 10.0f, 1.0f, &StrokeSettings::pressure_curve},
    StrokeParameter{"rotation_jitter", "degrees", "How far stamps are turned at random, either way", 0.0f,
                    180.0f, 0.0f, &StrokeSettings::rotation_jitter, tool_set({Tool::stamp})},
};

constexpr std::array kFlags{
    StrokeFlag{"along_stroke",
               "The image's right lies along the stroke; off, it stands upright in the picture",
               &StrokeSettings::along_stroke, tool_set({Tool::stamp})},
    StrokeFlag{"aligned", "Later strokes keep the first one's offset; off, each starts at the source again",
               &StrokeSettings::aligned, tool_set({Tool::clone})},
};

constexpr std::array<std::string_view, 3> kUnits{"world", "screen", "texel"};

}  // namespace

std::span<const StrokeParameter> stroke_parameters() {
    return kParameters;
}
std::span<const StrokeFlag> stroke_flags() {
    return kFlags;
}
std::span<const std::string_view> radius_unit_names() {
    return kUnits;
}

void check_stroke_settings(const StrokeSettings& settings) {
    for (const StrokeParameter& parameter : kParameters) {
        const float value = settings.*parameter.value;
        if (value >= parameter.low && value <= parameter.high) continue;  // false for NaN
        throw std::invalid_argument(
            std::string("stroke ")
                .append(parameter.name)
                .append(" is ")
                .append(number_text(static_cast<double>(value)))
                .append(": it must be ")
                .append(range_text(static_cast<double>(parameter.low), static_cast<double>(parameter.high))));
    }
}

}  // namespace relievo
