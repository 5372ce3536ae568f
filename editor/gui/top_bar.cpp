// The bar at the top: file, history, and the brush settings that change most often.
#include <imgui.h>

#include <string>

#include "editor/gui/panels.h"
#include "editor/gui/theme.h"
#include "editor/gui/widgets.h"
#include "renderer/methods/registry.h"

namespace relievo::gui {
namespace {

void label(const char* text) {
    ImGui::SameLine(0, points(14));
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", text);
    ImGui::SameLine(0, points(6));
}

void divider() {
    ImGui::SameLine(0, points(10));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine(at, {at.x, at.y + ImGui::GetFrameHeight()},
                                        ImGui::GetColorU32(ImGuiCol_ButtonHovered));
    ImGui::Dummy(ImVec2(points(1), 0));
    ImGui::SameLine(0, points(10));
}

void file_buttons(Desk& desk) {
    if (push_button("Open", true, "Open a scene  (Ctrl+O)")) desk.view.wanted = Dialog::open_scene;
    ImGui::SameLine();
    const bool unsaved = desk.session.unsaved();
    if (unsaved) ImGui::PushStyleColor(ImGuiCol_Text, kAccent);
    if (push_button("Save", true, "Save the map  (Ctrl+S)")) desk.save();
    if (unsaved) ImGui::PopStyleColor();
    ImGui::SameLine();
    if (push_button("Save as", true, "Save the map under another name or format  (Ctrl+Shift+S)"))
        desk.view.wanted = Dialog::save_as;
    divider();
    if (push_button("Undo", desk.session.can_undo(), "Ctrl+Z")) desk.undo();
    ImGui::SameLine();
    if (push_button("Redo", desk.session.can_redo(), "Ctrl+Shift+Z or Ctrl+Y")) desk.redo();
    divider();
}

void view_combo(Desk& desk) {
    const ViewInfo& now = view_info(desk.live.view());
    if (ImGui::BeginCombo("##view", std::string(now.name).c_str(), ImGuiComboFlags_HeightLarge)) {
        for (const ViewInfo& info : views()) {
            if (ImGui::Selectable(std::string(info.name).c_str(), info.view == now.view))
                desk.set_view(info.view);
            tooltip(info.tooltip, info.name);
        }
        ImGui::EndCombo();
    }
    tooltip(std::string(now.tooltip) + "\nV and Shift+V go through the views.", now.name);
}

}  // namespace

void falloff_combo(Desk& desk) {
    Brush& brush = desk.session.brush();
    const auto names = falloff_names();
    const std::string now(names[static_cast<std::size_t>(brush.falloff)]);
    if (ImGui::BeginCombo("##falloff", now.c_str())) {
        for (std::size_t i = 0; i < names.size(); ++i)
            if (ImGui::Selectable(std::string(names[i]).c_str(), names[i] == now))
                brush.falloff = static_cast<Falloff>(i);
        ImGui::EndCombo();
    }
    tooltip("How the brush fades from its centre to its rim.", "Falloff");
}

void method_combo(Desk& desk) {
    const Scene& scene = desk.session.scene();
    const Method& now = find_method(scene.method.name);
    if (ImGui::BeginCombo("##method", std::string(now.name).c_str())) {
        for (const Method* method : methods()) {
            if (ImGui::Selectable(std::string(method->name).c_str(), method == &now))
                desk.set("method", std::string(method->name));
            tooltip(method->limits, method->title);
        }
        ImGui::EndCombo();
    }
    tooltip(now.title, "Method of ray tracing");
}

void draw_top_bar(Desk& desk, const Box& box) {
    begin_panel("top", box, points(10), (static_cast<float>(box.height) - ImGui::GetFrameHeight()) / 2);
    file_buttons(desk);
    Brush& brush = desk.session.brush();
    const float radius = desk.mesh_radius();
    label("Size");
    ImGui::SetNextItemWidth(points(130));
    bar_slider("##size", brush.radius, {radius * 0.002f, radius * 2, true}, "%.4g");
    tooltip("Reach of the brush on the displaced surface, in world units.  [ and ] change it, F drags it.",
            "Size");
    label("Strength");
    ImGui::SetNextItemWidth(points(110));
    bar_slider("##strength", brush.strength, {0, 1}, "%.2f");
    tooltip("Draw: height of one pass. Level and erase: how far one stroke goes.  Shift+F drags it.",
            "Strength");
    label("Falloff");
    ImGui::SetNextItemWidth(points(96));
    falloff_combo(desk);
    label("Method");
    ImGui::SetNextItemWidth(points(110));
    method_combo(desk);
    label("View");
    ImGui::SetNextItemWidth(points(118));
    view_combo(desk);
    const float keys = ImGui::CalcTextSize("Keys").x + points(28);
    if (ImGui::GetContentRegionAvail().x > 0) ImGui::SameLine(static_cast<float>(box.width) - keys);
    if (push_button("Keys", true, "All keys and mouse buttons  (F1)")) desk.view.wanted = Dialog::keys;
    ImGui::End();
}

}  // namespace relievo::gui
