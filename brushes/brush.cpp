// The tables of brush settings and tools, and the range check that reads them.
#include "brushes/brush.h"

#include <array>
#include <sstream>
#include <stdexcept>

namespace relievo {
namespace {

constexpr std::array kParameters{
    BrushParameter{"radius", "world units", "Reach of the brush on the displaced surface, as a 3D distance",
                   1e-7f, 1e7f, 0.1f, &Brush::radius},
    BrushParameter{"strength", "",
                   "Draw: height of one pass. Level and erase: how far one stroke goes to the target", 0.0f,
                   1.0f, 0.5f, &Brush::strength},
    BrushParameter{"hardness", "", "The inner fraction of the radius at full strength", 0.0f, 0.99f, 0.0f,
                   &Brush::hardness},
    BrushParameter{"spacing", "of the radius",
                   "Distance along the surface from dab to dab; the height hardly depends on it", 0.02f, 1.0f,
                   0.15f, &Brush::spacing},
    BrushParameter{"level", "map value", "The map value that the level tool moves to", 0.0f, 1.0f, 0.5f,
                   &Brush::level},
};

constexpr std::array kTools{
    ToolInfo{Tool::draw, "draw", "Raises the surface along its normal; inverted, lowers it"},
    ToolInfo{Tool::smooth, "smooth", "Evens out bumps smaller than the brush"},
    ToolInfo{Tool::flatten, "flatten", "Pulls the surface towards the plane through what the brush covers"},
    ToolInfo{Tool::level, "level", "Moves the map to a set value"},
    ToolInfo{Tool::erase, "erase", "Takes the displacement away: moves the map to its midlevel"},
};

constexpr std::array<std::string_view, 4> kFalloffs{"smooth", "linear", "sharp", "constant"};

}  // namespace

std::span<const BrushParameter> brush_parameters() {
    return kParameters;
}
std::span<const ToolInfo> tools() {
    return kTools;
}
std::span<const std::string_view> falloff_names() {
    return kFalloffs;
}

void check_brush(const Brush& brush) {
    for (const BrushParameter& parameter : kParameters) {
        const float value = brush.*parameter.value;
        if (value >= parameter.low && value <= parameter.high) continue;  // false for NaN
        std::ostringstream message;
        message << "brush " << parameter.name << " is " << value << ": it must be " << parameter.low << " to "
                << parameter.high;
        throw std::invalid_argument(message.str());
    }
    if (static_cast<std::size_t>(brush.tool) >= kTools.size())
        throw std::invalid_argument("brush tool: no such tool");
    if (static_cast<std::size_t>(brush.falloff) >= kFalloffs.size())
        throw std::invalid_argument("brush falloff: no such falloff");
}

}  // namespace relievo
