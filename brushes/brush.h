// Brush settings as data: the command line, the panel and the journal read the same table (STYLE.md's habit
// 5).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace relievo {

enum class Tool : std::uint8_t { draw, smooth, flatten, level, erase };
enum class Falloff : std::uint8_t { smooth, linear, sharp, constant };

struct Brush {
    Tool tool = Tool::draw;
    Falloff falloff = Falloff::smooth;
    bool invert = false;    // draw lowers
    float radius = 0.1f;    // world units, > 0
    float strength = 0.5f;  // [0, 1]; what it means for each tool stands in brushes/dab_tools.h
    float hardness = 0.0f;  // [0, 1): the inner fraction of the radius at full strength
    float spacing = 0.15f;  // arc length between dabs as a fraction of the radius, [0.02, 1]
    float level = 0.5f;     // map value that the level tool moves to, [0, 1]
    bool operator==(const Brush&) const = default;
};

// One dab as it is journaled: quantised before it is used, so that live stroke and replay consume the same
// bits.
struct Dab {
    std::uint32_t time_us = 0;     // since the stroke began
    std::uint32_t face = 0;        // of the edited object's base mesh
    std::uint32_t b1 = 0, b2 = 0;  // barycentrics in units of 1 / kBarycentricOne; b1 + b2 <= kBarycentricOne
    std::uint32_t pressure = kPressureOne;  // in units of 1 / kPressureOne

    static constexpr std::uint32_t kBarycentricOne = 1u << 20;
    static constexpr std::uint32_t kPressureOne = 65535;
    bool operator==(const Dab&) const = default;
};

// One float setting, for menus, help and file checks. `name` is the key in journals.
struct BrushParameter {
    std::string_view name, unit, tooltip;
    float low, high, standard;
    float Brush::*value;
};
std::span<const BrushParameter> brush_parameters();

struct ToolInfo {
    Tool tool;
    std::string_view name, tooltip;  // name: lower case, the journal's word
};
std::span<const ToolInfo> tools();
std::span<const std::string_view> falloff_names();  // in the order of Falloff

// Throws std::invalid_argument that names the first setting outside its range (NaN included) and the range.
void check_brush(const Brush& brush);

}  // namespace relievo
