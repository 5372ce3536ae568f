// The column of tools at the left: one drawn icon each.
#include <imgui.h>

#include <algorithm>
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

double swollen(double x) {
    const double d = (x - 0.5) / 0.42;
    return d * d < 1 ? std::sqrt(1 - d * d) : 0;
}
double slab(double x) {
    return 0.55 / ((1 + std::exp(-(x - 0.18) * 60)) * (1 + std::exp((x - 0.82) * 60)));
}
double groove(double x) {
    return 0.75 - 0.85 * std::exp(-std::abs(x - 0.5) * 11);
}
double ridge(double x) {
    return 0.95 * std::exp(-std::abs(x - 0.5) * 11);
}
double wide_bump(double x) {
    return 0.7 * std::exp(-(x - 0.5) * (x - 0.5) * 12);
}
double dragged(double x) {
    return bump(x - 0.22);
}
double wave(double x) {
    return 0.45 + 0.35 * std::sin(x * 9.4);
}
double late_wave(double x) {
    return 0.45 + 0.35 * std::sin(x * 9.4 - 1.5) * (1 - 0.5 * x);
}
double grains(double x) {
    return 0.4 + 0.22 * std::sin(x * 23.0) + 0.2 * std::sin(x * 41.0 + 1);
}
double star(double x) {
    return std::max(0.0, 0.9 - 5 * std::abs(x - 0.28)) + std::max(0.0, 0.6 - 4 * std::abs(x - 0.72));
}
double copied(double x) {
    return bump(x * 1.9) + bump(x * 1.9 - 0.9);
}
double one_copied(double x) {
    return bump(x * 1.9);
}
double barrier(double x) {
    return x > 0.3 && x < 0.7 ? 0.9 : 0;
}

struct Icon {
    std::string_view tool;  // its name in tools()
    Profile before, after;
};
constexpr std::array kIcons{
    Icon{"draw", flat, bump},     Icon{"smooth", rough, gentle},     Icon{"flatten", bumpy_ramp, ramp},
    Icon{"level", bump, plateau}, Icon{"erase", bump, flat},         Icon{"inflate", bump, swollen},
    Icon{"clay", flat, slab},     Icon{"crease", flat, groove},      Icon{"pinch", wide_bump, ridge},
    Icon{"grab", bump, dragged},  Icon{"smear", wave, late_wave},    Icon{"noise", flat, grains},
    Icon{"stamp", flat, star},    Icon{"clone", one_copied, copied}, Icon{"mask", flat, barrier},
};

const Icon& icon_of(std::string_view tool) {
    for (const Icon& icon : kIcons)
        if (icon.tool == tool) return icon;
    return kIcons.front();
}

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

constexpr float kLeastRow = 21;  // points of height for a tool and the gap below it, in one column

std::string capitalised(std::string_view name) {
    std::string text(name);
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

// As keys.cpp has them.
std::string key_of(std::size_t index) {
    if (index < 9) return "  (" + std::to_string(index + 1) + ")";
    return index < 18 ? "  (Shift + " + std::to_string(index - 8) + ")" : "";
}

}  // namespace

void draw_tool_column(Desk& desk, const Box& box) {
    // Many tools in a low window: smaller buttons, in two columns where it is lower still, so that all are
    // there.
    const std::size_t count = tools().size();
    const auto room_for = [&](std::size_t rows) {
        return (static_cast<float>(box.height) - points(20)) / static_cast<float>(rows);
    };
    const std::size_t across = room_for(count) < points(kLeastRow) ? 2 : 1;
    const float room = room_for((count + across - 1) / across);
    const float gap = std::min(ImGui::GetStyle().ItemSpacing.y, room * 0.15f);
    const float size = std::clamp(room - gap, points(12), points(across == 1 ? 44 : 26));
    const auto columns = static_cast<float>(across);
    const float pad = (static_cast<float>(box.width) - columns * size - (columns - 1) * gap) / 2;
    begin_panel("tools", box, pad, points(10));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
    const Brush& brush = desk.session.brush();
    for (std::size_t i = 0; i < count; ++i) {
        const ToolInfo& tool = tools()[i];
        if (i % across > 0) ImGui::SameLine();
        if (tool_button(tool, icon_of(tool.name), size, brush.tool == tool.tool)) desk.choose_tool(i);
        tooltip(tool.tooltip, capitalised(tool.name) + key_of(i));
    }
    ImGui::PopStyleVar();
    ImGui::End();
}

}  // namespace relievo::gui
