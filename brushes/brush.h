// Brush settings as data: the command line, the panel and the journal read the same table (STYLE.md's habit
// 5).
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>

#include "brushes/falloff_curve.h"

namespace relievo {

enum class Tool : std::uint8_t {
    draw,
    smooth,
    flatten,
    level,
    erase,
    inflate,
    clay,
    crease,
    pinch,
    grab,
    smear,
    noise,
    stamp,
    clone,
    mask
};
enum class Axis : std::uint8_t { x, y, z };
enum class Falloff : std::uint8_t { smooth, linear, sharp, constant, custom };
// What a tool that raises or lowers, or smooth, changes; other tools change heights alone.
enum class Paint : std::uint8_t { height, colour, both };
// saved: the map as it was last saved, or, before that, loaded.
enum class EraseTo : std::uint8_t { midlevel, saved };

struct Brush {
    Tool tool = Tool::draw;
    Falloff falloff = Falloff::smooth;
    bool invert =
        false;  // the opposite: draw and stamp lower, pinch spreads, clay scrapes, crease raises, mask frees
    float radius = 0.1f;  // world units, > 0
    float strength = 0.5f;   // [0, 1]; what it means for each tool stands in brushes/dab_tools.h
    float hardness = 0.0f;   // [0, 1): the inner fraction of the radius at full strength
    float spacing = 0.15f;   // arc length between dabs as a fraction of the radius, [0.02, 1]
    float level = 0.5f;      // map value that the level tool moves to, [0, 1]
    float grain = 0.25f;     // size of the noise tool's bumps as a fraction of the radius, [0.02, 4]
    float seed = 0.0f;       // which noise, a whole number in [0, 65535]
    float stamp_spacing = 2.0f;  // of the stamp tool, in the place of spacing, [0.1, 8]
    float rotation = 0.0f;       // of the stamp's image, degrees anticlockwise, [-180, 180]
    bool accumulate = true;  // false: passing again within the stroke adds nothing
    // Symmetry in the object's own space, about its origin: the stroke is repeated by every combination.
    bool mirror_x = false, mirror_y = false, mirror_z = false;
    float radial = 1.0f;         // turns, a whole number in [1, 64]; 1: none
    Axis radial_axis = Axis::y;  // that they go about
    Paint paint = Paint::height;
    float red = 0.8f, green = 0.3f, blue = 0.2f;  // sRGB-encoded, as the colour map holds them, [0, 1]
    EraseTo erase_to = EraseTo::midlevel;         // of the erase tool
    FalloffCurve falloff_curve{};                 // of the custom falloff
    bool blur = false;  // of the mask tool: softens the mask in the place of painting it
    bool operator==(const Brush&) const = default;
};

// A point of the base mesh, quantised.
struct FacePoint {
    std::uint32_t face = 0;
    std::uint32_t b1 = 0, b2 = 0;  // as in Dab
    bool operator==(const FacePoint&) const = default;
};

// One dab as it is journaled: quantised before it is used, so that live stroke and replay consume the same
// bits.
struct Dab {
    std::uint32_t time_us = 0;     // since the stroke began
    std::uint32_t face = 0;        // of the edited object's base mesh
    std::uint32_t b1 = 0, b2 = 0;  // barycentrics in units of 1 / kBarycentricOne; b1 + b2 <= kBarycentricOne
    std::uint32_t pressure = kPressureOne;  // of the strength, in units of 1 / kPressureOne
    std::uint32_t size = kSizeOne;          // of the brush's radius, in units of 1 / kSizeOne, [1, kSizeOne]
    // What the hand adds, in world space and in units of 1 / kDragOne. Other tools do not read it.
    // grab: how far it has drawn what it grabbed since the stroke began, over the brush's radius.
    // stamp: a direction; the image's right lies along the surface as near to it as can be. 0: any.
    // clone: the turn from the target to the source, as the vector part of a unit quaternion whose scalar is
    // not negative.
    std::array<std::int32_t, 3> drag{};

    static constexpr std::uint32_t kBarycentricOne = 1u << 20;
    static constexpr std::uint32_t kPressureOne = 65535;
    static constexpr std::uint32_t kSizeOne = 65535;
    static constexpr std::int32_t kDragOne = 1 << 16;
    static constexpr std::int32_t kLargestDrag = 1 << 28;
    bool operator==(const Dab&) const = default;
};

// A set of tools, for settings that not every tool reads.
using ToolSet = std::uint32_t;
constexpr ToolSet tool_set(std::initializer_list<Tool> tools) {
    ToolSet set = 0;
    for (const Tool tool : tools) set |= 1u << static_cast<unsigned>(tool);
    return set;
}
// The tools that raise or lower, which may paint as well; and smooth, which may even out colours.
inline constexpr ToolSet kColouringTools =
    tool_set({Tool::draw, Tool::level, Tool::inflate, Tool::clay, Tool::crease, Tool::noise,
              Tool::stamp});
inline constexpr ToolSet kPaintingTools = kColouringTools | tool_set({Tool::smooth});
constexpr ToolSet kEveryTool = ~ToolSet{0};
constexpr bool holds(ToolSet set, Tool tool) {
    return (set & tool_set({tool})) != 0;
}

// One float setting, for menus, help and file checks. `name` is the key in journals.
struct BrushParameter {
    std::string_view name, unit, tooltip;
    float low, high, standard;
    float Brush::*value;
    ToolSet tools = kEveryTool;  // that read it
};
std::span<const BrushParameter> brush_parameters();

// One switch.
struct BrushFlag {
    std::string_view name, tooltip;
    bool standard;
    bool Brush::*value;
    ToolSet tools = kEveryTool;
};
std::span<const BrushFlag> brush_flags();

struct ToolInfo {
    Tool tool;
    std::string_view name, tooltip;  // name: lower case, the journal's word
};
std::span<const ToolInfo> tools();
std::span<const std::string_view> falloff_names();  // in the order of Falloff
std::span<const std::string_view> axis_names();     // in the order of Axis
std::span<const std::string_view> paint_names();    // in the order of Paint
std::span<const std::string_view> erase_to_names();  // in the order of EraseTo

// Whether a stroke changes the colour map, and whether it changes anything else.
inline bool paints(const Brush& brush) {
    return brush.paint != Paint::height && holds(kPaintingTools, brush.tool);
}
inline bool sculpts(const Brush& brush) {
    return !(paints(brush) && brush.paint == Paint::colour);
}

// Throws std::invalid_argument that names the first setting outside its range (NaN included) and the range.
void check_brush(const Brush& brush);

// Of a mesh of `faces` faces. Throws std::out_of_range that says what it found and what would be right.
void check_point(const FacePoint& point, std::uint32_t faces);
void check_dab(const Dab& dab, std::uint32_t faces);

}  // namespace relievo
