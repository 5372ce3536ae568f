// How a gesture becomes dabs, as data: what StrokeInput reads beside the brush. Resolved before a dab is
// made, so that no journal holds it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "brushes/brush.h"

namespace relievo {

enum class RadiusUnit : std::uint8_t { world, screen, texel };

struct StrokeSettings {
    RadiusUnit unit = RadiusUnit::world;  // world: the brush's own radius
    float radius_px = 40.0f;              // of the picture, for screen
    float radius_texels = 16.0f;          // for texel
    float jitter = 0.0f;                  // of the radius: dabs stray so far, [0, 2]
    float lazy_px = 0.0f;                 // the brush follows the pointer on a string so long, [0, 500]
    float rate = 0.0f;                    // dabs a second, also at rest, in place of spacing; 0: off
    float size_by_pressure = 0.0f;        // 0: the pen does not matter; 1: no pressure is no size
    float strength_by_pressure = 1.0f;    // the same for strength
    float pressure_curve = 1.0f;          // the pen's pressure counts to this power, [0.1, 10]
    // Of the stamp's image, resolved into each dab (Dab::drag).
    bool along_stroke = false;     // its right lies along the stroke; false: along the picture's right
    float rotation_jitter = 0.0f;  // degrees: stamps stray so far either way, [0, 180]
    bool aligned = true;  // of clone: later strokes keep the offset; false: each starts at the source
    std::uint32_t seed = 0;               // of the jitter
};

struct StrokeParameter {
    std::string_view name, unit, tooltip;
    float low, high, standard;
    float StrokeSettings::*value;
    ToolSet tools = kEveryTool;  // that read it
};
std::span<const StrokeParameter> stroke_parameters();

struct StrokeFlag {
    std::string_view name, tooltip;
    bool StrokeSettings::*value;
    ToolSet tools;
};
std::span<const StrokeFlag> stroke_flags();
std::span<const std::string_view> radius_unit_names();  // in the order of RadiusUnit

// Throws std::invalid_argument that names the first setting outside its range (NaN included) and the range.
void check_stroke_settings(const StrokeSettings& settings);

}  // namespace relievo
