// The status bar's hint names what each key does, and no key that does nothing.
#include "editor/gui/tool_hint.h"

#include <gtest/gtest.h>

#include <set>

namespace relievo::gui::tool_hint_test {
namespace {

bool has_opposite(Tool tool) {
    for (const BrushFlag& flag : brush_flags())
        if (flag.value == &Brush::invert) return holds(flag.tools, tool);
    return false;
}

bool names(const std::string& hint, const char* word) {
    return hint.find(word) != std::string::npos;
}

TEST(ToolHint, NamesTheModifiersThatDoSomethingAlone) {
    std::set<std::string> all;
    for (const ToolInfo& info : tools()) {
        Brush brush;
        brush.tool = info.tool;
        const std::string hint = tool_hint(brush);
        EXPECT_TRUE(all.insert(hint).second) << hint;
        EXPECT_EQ(names(hint, "Ctrl"), has_opposite(info.tool) || info.tool == Tool::clone) << hint;
        EXPECT_EQ(names(hint, "Shift smooths heights"), info.tool != Tool::smooth && info.tool != Tool::mask) << hint;
        EXPECT_EQ(names(hint, "Shift blurs the mask"), info.tool == Tool::mask) << hint;
        brush.invert = true;
        if (info.tool != Tool::noise) EXPECT_EQ(tool_hint(brush) != hint, has_opposite(info.tool)) << hint;
    }
}

TEST(ToolHint, SaysWhetherColoursOrHeightsAreChanged) {
    for (const ToolInfo& info : tools()) {
        Brush brush;
        brush.tool = info.tool;
        brush.paint = Paint::colour;
        const std::string hint = tool_hint(brush);
        EXPECT_EQ(names(hint, "goes back to heights"), holds(kPaintingTools, info.tool)) << hint;
        EXPECT_EQ(names(hint, "Shift smooths colours"), info.tool != Tool::smooth && info.tool != Tool::mask) << hint;
        EXPECT_FALSE(names(hint, "Ctrl") && holds(kPaintingTools, info.tool)) << "invert turns no colours: " << hint;
    }
}

}  // namespace
}  // namespace relievo::gui::tool_hint_test
