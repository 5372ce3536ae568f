// The panel at the right: sections for brush, map, method, lights and material, render.
#include <imgui.h>

#include <cmath>
#include <string>

#include "editor/gui/panels.h"
#include "editor/gui/theme.h"
#include "editor/gui/widgets.h"

namespace relievo::gui {
namespace {

// The border between picture and panel can be dragged.
void draw_splitter(Desk& desk, const Box& box) {
    const float grip = points(6);
    ImGui::SetCursorScreenPos({static_cast<float>(box.x), static_cast<float>(box.y)});
    ImGui::InvisibleButton("splitter", ImVec2(grip, static_cast<float>(box.height)));
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + points(2), high.y}, kAccent);
    }
    if (ImGui::IsItemActive()) desk.view.side_width -= ImGui::GetIO().MouseDelta.x;
}

}  // namespace

void begin_panel(const char* name, const Box& box, float pad_x, float pad_y) {
    ImGui::SetNextWindowPos({static_cast<float>(box.x), static_cast<float>(box.y)});
    ImGui::SetNextWindowSize({static_cast<float>(box.width), static_cast<float>(box.height)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(pad_x, pad_y));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar(2);
    ImGui::GetWindowDrawList()->AddRect(
        {static_cast<float>(box.x) - 1, static_cast<float>(box.y) - 1},
        {static_cast<float>(box.x + box.width) + 1, static_cast<float>(box.y + box.height) + 1}, kLine);
}

void draw_map_section(Desk& desk) {
    if (!section("Map")) return;
    const HeightMap& map = desk.session.map();
    const Displacement& d = desk.session.scene().objects.front().displacement;
    const auto path = desk.session.map_path();
    if (!d.procedural) {
        text_row("File", path ? path->filename().string() : "not saved yet");
        if (path) tooltip(path->string());
    }
    text_row(d.procedural ? "Exemplar" : "Texels",
             std::to_string(map.width()) + " x " + std::to_string(map.height()) + ", 16 bit");
    if (desk.session.colours()) {
        const auto colours = desk.session.colour_path();
        text_row("Colours", colours ? colours->filename().string() : "not saved yet");
        if (colours) tooltip(colours->string());
    }
    auto amplitude = static_cast<float>(d.amplitude);
    const float most = std::max(desk.mesh_radius(), std::abs(amplitude));
    if (slider_row("Amplitude", amplitude, {-most, most, false, "%.4g"},
                   "World units from map value 0 to 1. Negative turns the relief inside out."))
        desk.set("amplitude", static_cast<double>(amplitude));
    auto midlevel = static_cast<float>(d.midlevel);
    if (slider_row("Midlevel", midlevel, {0, 1}, "The map value that does not displace."))
        desk.set("midlevel", static_cast<double>(midlevel));
}

void draw_side_panel(Desk& desk, const Box& box) {
    begin_panel("side", box, points(12), points(10));
    ImGui::BeginChild("sections", ImVec2(0, 0), false, ImGuiWindowFlags_NoNav);
    draw_brush_section(desk);
    draw_map_section(desk);
    draw_source_section(desk);
    draw_method_section(desk);
    draw_lights_section(desk);
    draw_render_section(desk);
    ImGui::EndChild();
    draw_splitter(desk, box);
    ImGui::End();
}

}  // namespace relievo::gui
