// The hints of all tools.
#include "editor/gui/tool_hint.h"

#include <array>
#include <string_view>

namespace relievo::gui {
namespace {

// The second pair is of the inverted brush; empty where the tool has no opposite.
struct Hint {
    Tool tool;
    std::string_view drag, control;
    std::string_view inverted_drag = {}, inverted_control = {};
};

constexpr std::array kHints{
    Hint{Tool::draw, "Drag to raise", "Ctrl lowers", "Drag to lower", "Ctrl raises"},
    Hint{Tool::smooth, "Drag to smooth", ""},
    Hint{Tool::flatten, "Drag to flatten", ""},
    Hint{Tool::level, "Drag to bring to the level", ""},
    Hint{Tool::erase, "Drag to take the displacement away", ""},
    Hint{Tool::inflate, "Drag to swell", "Ctrl shrinks", "Drag to shrink", "Ctrl swells"},
    Hint{Tool::clay, "Drag to lay clay on", "Ctrl scrapes", "Drag to scrape", "Ctrl lays clay on"},
    Hint{Tool::crease, "Drag to cut a groove", "Ctrl raises a ridge", "Drag to raise a ridge", "Ctrl cuts a groove"},
    Hint{Tool::pinch, "Drag to draw the relief in", "Ctrl spreads it", "Drag to spread the relief", "Ctrl draws it in"},
    Hint{Tool::grab, "Drag to move the surface", ""},
    Hint{Tool::smear, "Drag to carry the relief along", ""},
    Hint{Tool::noise, "Drag to roughen", "Ctrl makes dents of bumps", "Drag to roughen", "Ctrl makes dents of bumps"},
    Hint{Tool::stamp, "Click to stamp, drag for a row", "Ctrl lowers", "Click to stamp down, drag for a row",
         "Ctrl raises"},
    Hint{Tool::clone, "Drag to copy relief", "Ctrl+click says where from"},
    Hint{Tool::mask, "Drag to protect", "Ctrl frees", "Drag to free", "Ctrl protects"},
};

const Hint& hint_of(Tool tool) {
    for (const Hint& hint : kHints)
        if (hint.tool == tool) return hint;
    return kHints.front();
}

}  // namespace

std::string tool_hint(const Brush& brush) {
    const bool evens = brush.tool == Tool::smooth;
    if (!sculpts(brush))
        return std::string(evens ? "Drag to smooth colours" : "Drag to paint; Shift smooths colours") +
               "; S takes one, P goes back to heights";
    if (brush.tool == Tool::mask && brush.blur) return "Drag to blur the mask";
    const Hint& hint = hint_of(brush.tool);
    const bool inverted = brush.invert && !hint.inverted_drag.empty();
    std::string text(inverted ? hint.inverted_drag : hint.drag);
    if (brush.tool == Tool::erase && brush.erase_to == EraseTo::saved) text = "Drag to go back to what was saved";
    if (const auto control = inverted ? hint.inverted_control : hint.control; !control.empty())
        text += "; " + std::string(control);
    if (brush.tool == Tool::mask)
        text += "; Shift blurs the mask";
    else if (!evens)  // Shift is the smooth tool: it evens out what is painted
        text += brush.paint == Paint::colour ? "; Shift smooths colours" : "; Shift smooths heights";
    if (brush.tool == Tool::stamp) text += "; Alt+F turns";
    return text;
}

}  // namespace relievo::gui
