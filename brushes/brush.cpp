// The tables of brush settings and tools, and what brushes and dabs may hold.
#include "brushes/brush.h"

#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace relievo {
namespace {

constexpr ToolSet kRaising =
    tool_set({Tool::draw, Tool::inflate, Tool::clay, Tool::crease, Tool::noise, Tool::stamp});

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
                   0.15f, &Brush::spacing, kEveryTool & ~tool_set({Tool::stamp})},
    BrushParameter{"level", "map value", "The map value that the level tool moves to", 0.0f, 1.0f, 0.5f,
                   &Brush::level, tool_set({Tool::level})},
    BrushParameter{"grain", "of the radius", "Size of the bumps that noise makes", 0.02f, 4.0f, 0.25f,
                   &Brush::grain, tool_set({Tool::noise})},
    BrushParameter{"seed", "", "Another number gives other bumps", 0.0f, 65535.0f, 0.0f, &Brush::seed,
                   tool_set({Tool::noise})},
    BrushParameter{"stamp_spacing", "of the radius",
                   "Distance along the surface from stamp to stamp; 2 puts them side by side", 0.1f, 8.0f,
                   2.0f, &Brush::stamp_spacing, tool_set({Tool::stamp})},
    BrushParameter{"rotation", "degrees", "Turns the image anticlockwise", -180.0f, 180.0f, 0.0f,
                   &Brush::rotation, tool_set({Tool::stamp})},
    BrushParameter{"radial", "turns", "Copies of the stroke around an axis of the object; 1 is none", 1.0f,
                   64.0f, 1.0f, &Brush::radial},
    BrushParameter{"red", "sRGB", "Of the colour that is painted", 0.0f, 1.0f, 0.8f, &Brush::red,
                   kColouringTools},
    BrushParameter{"green", "sRGB", "Of the colour that is painted", 0.0f, 1.0f, 0.3f, &Brush::green,
                   kColouringTools},
    BrushParameter{"blue", "sRGB", "Of the colour that is painted", 0.0f, 1.0f, 0.2f, &Brush::blue,
                   kColouringTools},
};

constexpr std::array kFlags{
    BrushFlag{"invert",
              "The opposite: draw and stamp lower, pinch spreads, clay scrapes, crease raises, mask frees",
              false, &Brush::invert, kRaising | tool_set({Tool::pinch, Tool::mask})},
    BrushFlag{"accumulate", "Each pass of a stroke adds to the last; off, a stroke has one height throughout",
              true, &Brush::accumulate, tool_set({Tool::draw, Tool::inflate, Tool::noise, Tool::stamp})},
    BrushFlag{"blur", "Softens the mask's borders in the place of painting it, as Shift does", false, &Brush::blur,
              tool_set({Tool::mask})},
    BrushFlag{"mirror_x", "Every dab is repeated across the plane x = 0 of the object", false,
              &Brush::mirror_x},
    BrushFlag{"mirror_y", "Every dab is repeated across the plane y = 0 of the object", false,
              &Brush::mirror_y},
    BrushFlag{"mirror_z", "Every dab is repeated across the plane z = 0 of the object", false,
              &Brush::mirror_z},
};

constexpr std::array kTools{
    ToolInfo{Tool::draw, "draw", "Raises the surface along its normal; inverted, lowers it"},
    ToolInfo{Tool::smooth, "smooth", "Evens out bumps smaller than the brush"},
    ToolInfo{Tool::flatten, "flatten", "Pulls the surface towards the plane through what the brush covers"},
    ToolInfo{Tool::level, "level", "Moves the map to a set value"},
    ToolInfo{Tool::erase, "erase",
             "Takes the displacement away: moves the map to its midlevel, or to what was saved"},
    ToolInfo{Tool::inflate, "inflate", "Swells the relief outwards, its slopes most; inverted, shrinks it"},
    ToolInfo{Tool::clay, "clay", "Lays clay on: fills what is low first; inverted, scrapes what is high"},
    ToolInfo{Tool::crease, "crease", "Cuts a sharp groove and draws its banks in; inverted, a sharp ridge"},
    ToolInfo{Tool::pinch, "pinch", "Draws the relief in towards the stroke; inverted, spreads it"},
    ToolInfo{Tool::grab, "grab", "Takes hold of the surface and moves it with the hand"},
    ToolInfo{Tool::smear, "smear", "Carries the relief along with the stroke"},
    ToolInfo{Tool::noise, "noise", "Roughens the surface with bumps of a set size"},
    ToolInfo{Tool::stamp, "stamp", "Presses an image into the surface; inverted, lowers it"},
    ToolInfo{Tool::clone, "clone", "Copies the relief from elsewhere, which moves along with the stroke"},
    ToolInfo{Tool::mask, "mask", "Paints what every other tool leaves as it is; inverted, frees it again"},
};

constexpr std::array<std::string_view, 5> kFalloffs{"smooth", "linear", "sharp", "constant", "custom"};
constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
constexpr std::array<std::string_view, 3> kPaints{"height", "colour", "both"};
constexpr std::array<std::string_view, 2> kErasesTo{"midlevel", "saved"};

}  // namespace

std::span<const BrushParameter> brush_parameters() {
    return kParameters;
}
std::span<const BrushFlag> brush_flags() {
    return kFlags;
}
std::span<const ToolInfo> tools() {
    return kTools;
}
std::span<const std::string_view> falloff_names() {
    return kFalloffs;
}
std::span<const std::string_view> axis_names() {
    return kAxes;
}
std::span<const std::string_view> paint_names() {
    return kPaints;
}
std::span<const std::string_view> erase_to_names() {
    return kErasesTo;
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
    for (const float whole : {brush.seed, brush.radial})
        if (whole != std::floor(whole))
            throw std::invalid_argument(std::string("brush ") + (whole == brush.seed ? "seed" : "radial") +
                                        ": must be a whole number");
    if (static_cast<std::size_t>(brush.radial_axis) >= kAxes.size())
        throw std::invalid_argument("brush radial_axis: no such axis");
    if (static_cast<std::size_t>(brush.paint) >= kPaints.size())
        throw std::invalid_argument("brush paint: no such choice");
    if (static_cast<std::size_t>(brush.erase_to) >= kErasesTo.size())
        throw std::invalid_argument("brush erase_to: no such choice");
    if (static_cast<std::size_t>(brush.tool) >= kTools.size())
        throw std::invalid_argument("brush tool: no such tool");
    if (static_cast<std::size_t>(brush.falloff) >= kFalloffs.size())
        throw std::invalid_argument("brush falloff: no such falloff");
}

void check_point(const FacePoint& point, std::uint32_t faces) {
    if (point.face >= faces)
        throw std::out_of_range("dab on face " + std::to_string(point.face) + " of a mesh with " +
                                std::to_string(faces) + " faces");
    if (point.b1 > Dab::kBarycentricOne || point.b2 > Dab::kBarycentricOne - point.b1)
        throw std::out_of_range("dab outside its face: barycentrics " + std::to_string(point.b1) + " and " +
                                std::to_string(point.b2) + " must add up to at most " +
                                std::to_string(Dab::kBarycentricOne));
}

void check_dab(const Dab& dab, std::uint32_t faces) {
    check_point({dab.face, dab.b1, dab.b2}, faces);
    if (dab.size < 1 || dab.size > Dab::kSizeOne)
        throw std::out_of_range("dab of size " + std::to_string(dab.size) + ": it must be 1 to " +
                                std::to_string(Dab::kSizeOne));
    for (const std::int32_t part : dab.drag)
        if (part < -Dab::kLargestDrag || part > Dab::kLargestDrag)
            throw std::out_of_range("dab with a drag of " + std::to_string(part) + ": it must be at most " +
                                    std::to_string(Dab::kLargestDrag) + " either way");
}

}  // namespace relievo
