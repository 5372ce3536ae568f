// The column of tools at the left: one drawn icon each.
#include <imgui.h>

#include <array>
#include <cmath>
#include <string>

#include "editor/gui/panels.h"
#include "editor/gui/theme.h"
#include "editor/gui/widgets.h"

namespace relievo::gui {
namespace {

// Icons are profiles of a surface in the unit square, y down: the old one thin, the new one bold.
using Profile = double (*)(double x);

double bump(double x) {
    const double d = (x - 0.5) / 0.36;
    return d * d < 1 ? (1 - d * d) * (1 - d * d) : 0;
}
double flat(double) {
    return 0;
}
double rough(double x) {
    return 0.5 + 0.5 * std::sin(x * 19.0) * (0.4 + 0.6 * bump(x));
}
double gentle(double x) {
    return 0.5 + 0.17 * std::sin(x * 6.3);
}
double ramp(double x) {
    return 0.95 - 0.9 * x;
}
double bumpy_ramp(double x) {
    return ramp(x) * 0.75 + 0.25 * std::sin(x * 16.0) * bump(x) + 0.15;
}
double plateau(double x) {
    const double edge = 0.16 * (std::tanh((x - 0.2) * 14) - std::tanh((x - 0.8) * 14));
    return edge * 2.6;
}

struct Icon {
    Profile before, after;
};
// In the order of tools(): draw, smooth, flatten, level, erase.
constexpr std::array kIcons{Icon{flat, bump}, Icon{rough, gentle}, Icon{bumpy_ramp, ramp},
                            Icon{bump, plateau}, Icon{bump, flat}};

void draw_profile(ImDrawList& list, ImVec2 low, float size, Profile profile, ImU32 colour, float width) {
    constexpr int kSteps = 32;
    std::array<ImVec2, kSteps + 1> line;
    for (int i = 0; i <= kSteps; ++i) {
        const double x = static_cast<double>(i) / kSteps;
        line[static_cast<std::size_t>(i)] = {low.x + size * static_cast<float>(x),
                                             low.y + size * static_cast<float>(0.8 - 0.6 * profile(x))};
    }
    list.AddPolyline(line.data(), kSteps + 1, colour, 0, width);
}

bool tool_button(const ToolInfo& tool, const Icon& icon, float size, bool chosen) {
    ImGui::PushID(tool.name.data(), tool.name.data() + tool.name.size());
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const bool pushed = ImGui::InvisibleButton("tool", ImVec2(size, size));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 high(low.x + size, low.y + size);
    if (chosen) {
        list.AddRectFilled(low, high, kAccentDim, points(5));
        list.AddRect(low, high, kAccent, points(5), 0, points(1));
    } else if (ImGui::IsItemHovered()) {
        list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_ButtonHovered), points(5));
    }
    const float inset = size * 0.2f;
    const ImVec2 corner(low.x + inset, low.y + inset);
    draw_profile(list, corner, size - 2 * inset, icon.before, kTextDim, points(1));
    draw_profile(list, corner, size - 2 * inset, icon.after, chosen ? IM_COL32_WHITE : kText, points(2.2f));
    ImGui::PopID();
    return pushed;
}

std::string capitalised(std::string_view name) {
    std::string text(name);
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

}  // namespace

void draw_tool_column(Desk& desk, const Box& box) {
    const float size = points(44);
    const float pad = (static_cast<float>(box.width) - size) / 2;
    begin_panel("tools", box, pad, points(10));
    Brush& brush = desk.session.brush();
    for (std::size_t i = 0; i < tools().size(); ++i) {
        const ToolInfo& tool = tools()[i];
        if (tool_button(tool, kIcons[i % kIcons.size()], size, brush.tool == tool.tool)) desk.choose_tool(i);
        tooltip(tool.tooltip, capitalised(tool.name) + "  (" + std::to_string(i + 1) + ")");
    }
    ImGui::End();
}

}  // namespace relievo::gui
