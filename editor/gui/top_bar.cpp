// The bar at the top: file, history, and the brush settings that change most often.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "editor/gui/panels.h"
#include "editor/gui/theme.h"
#include "editor/gui/widgets.h"
#include "editor/session/derived_scene.h"
#include "editor/session/preferences.h"
#include "editor/session/text.h"
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

// Names, and as much of the ends of their folders as has room beside the menu: a list that is too wide would lie over
// the menu, with an entry under the pointer that opened it.
void recent_menu(Desk& desk) {
    const float least = points(60), most = points(560), frame = points(100);
    const float beside = ImGui::GetMainViewport()->Size.x - ImGui::GetWindowPos().x - ImGui::GetWindowWidth() - frame;
    if (!ImGui::BeginMenu("Recent")) return;
    const std::vector<std::filesystem::path> recent = load_preferences().recent;
    float names = 0;
    for (const std::filesystem::path& path : recent) names = std::max(names, text_width(scene_name(path)));
    for (const std::filesystem::path& path : recent) {
        std::error_code ignored;
        const std::string whole = path.string(), name = scene_name(path);
        const float room = std::min(beside, most) - names;
        const std::string folder = room < least ? "" : fitting_end(path.parent_path().string(), room, text_width);
        ImGui::PushID(whole.c_str());
        if (ImGui::MenuItem(name.c_str(), folder.c_str(), false, std::filesystem::exists(path, ignored)))
            desk.open_file(path);
        tooltip(whole);
        ImGui::PopID();
    }
    ImGui::EndMenu();
}

// Fonts are made when a scene is opened.
void scale_menu(Desk& desk) {
    if (!ImGui::BeginMenu("Interface size")) return;
    const double now = load_preferences().interface_scale;
    for (const double scale : {0.0, 1.0, 1.25, 1.5, 2.0}) {
        const std::string name = scale == 0 ? "the display's" : formatted("%.0f %%", 100 * scale);
        if (!ImGui::MenuItem(name.c_str(), nullptr, scale == now)) continue;
        if (desk.attempt([&] { change_preferences([&](Preferences& p) { p.interface_scale = scale; }); }))
            desk.toasts.info("The interface has that size from the next file on that is opened");
    }
    ImGui::EndMenu();
}

void file_menu(Desk& desk) {
    if (push_button("File", true, {})) ImGui::OpenPopup("file");
    ImGui::SetNextWindowPos({ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y});
    end_list_in_window(ImGui::GetItemRectMax().y);
    if (!ImGui::BeginPopup("file")) return;
    keep_folded_while_scrolling();
    const auto item = [&](const char* name, const char* keys, Dialog dialog) {
        if (ImGui::MenuItem(name, keys)) desk.view.wanted = dialog;
    };
    item("New map...", "Ctrl+N", Dialog::new_map);
    item("Open...", "Ctrl+O", Dialog::open);
    recent_menu(desk);
    ImGui::Separator();
    if (ImGui::MenuItem("Save", "Ctrl+S")) desk.save();
    item("Save as...", "Ctrl+Shift+S", Dialog::save_as);
    item("Export...", "Ctrl+E", Dialog::export_map);
    item("Export the colours...", nullptr, Dialog::export_colours);
    if (ImGui::MenuItem("Revert", nullptr, false, desk.session.unsaved())) desk.revert();
    tooltip("To what was last saved or loaded, by undo; redo goes back.");
    ImGui::Separator();
    item("Save the picture...", nullptr, Dialog::save_picture);
    if (ImGui::MenuItem("Screenshot", "F12")) desk.view.screenshot_wanted = true;
    scale_menu(desk);
    if (ImGui::MenuItem("Quit", "Ctrl+Q")) desk.leave({});
    // With the list over it, which the pointer would open again; and after that, or it would stay, without a menu to
    // draw it.
    if (escape_pressed()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void file_buttons(Desk& desk) {
    file_menu(desk);
    ImGui::SameLine();
    const bool unsaved = desk.session.unsaved();
    if (unsaved) ImGui::PushStyleColor(ImGuiCol_Text, kAccent);
    if (push_button("Save", true, "Save the map  (Ctrl+S)")) desk.save();
    if (unsaved) ImGui::PopStyleColor();
    divider();
    if (push_button("Undo", desk.session.can_undo(), "Ctrl+Z")) desk.undo();
    ImGui::SameLine();
    if (push_button("Redo", desk.session.can_redo(), "Ctrl+Shift+Z or Ctrl+Y")) desk.redo();
    divider();
}

float label_width(const char* text) {
    return points(14) + ImGui::CalcTextSize(text).x + points(6);
}

// What stands on a slider; its name too, where the bar has no room for a label.
std::string on_slider(bool labelled, const char* name, const char* format) {
    return labelled ? format : std::string(name) + " " + format;
}

void size_slider(Desk& desk, bool labelled) {
    const auto [value, range] = size_setting(desk);
    bar_slider("##size", value, range, on_slider(labelled, "size", range.format).c_str());
    tooltip(
        "Reach of the brush on the displaced surface; its unit is chosen at the right.  [ and ] change it, F "
        "drags it.",
        "Size");
}

void strength_slider(Desk& desk, bool labelled) {
    bar_slider("##strength", desk.session.brush().strength, {0, 1},
               on_slider(labelled, "strength", "%.2f").c_str());
    tooltip("Draw: height of one pass. Level and erase: how far one stroke goes.  Shift+F drags it.",
            "Strength");
}

void symmetry_buttons(Desk& desk, bool) {
    constexpr std::array kFlags{&Brush::mirror_x, &Brush::mirror_y, &Brush::mirror_z};
    constexpr std::array kNames{"X", "Y", "Z"};
    for (std::size_t axis = 0; axis < kFlags.size(); ++axis) {
        if (axis > 0) ImGui::SameLine(0, points(4));
        const bool on = desk.session.brush().*kFlags[axis];
        if (on) ImGui::PushStyleColor(ImGuiCol_Button, kAccentDim);
        if (push_button(kNames[axis], true, "Symmetry across this axis of the object; X, Y and Z toggle it."))
            desk.toggle_symmetry(axis);
        if (on) ImGui::PopStyleColor();
    }
}

void view_combo(Desk& desk, bool) {
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

SizeSetting size_setting(Desk& desk) {
    const float radius = desk.mesh_radius();
    StrokeSettings& settings = desk.session.stroke_settings();
    switch (settings.unit) {
        case RadiusUnit::screen:
            return {settings.radius_px, {1, 2000, true, "%.0f px"}};
        case RadiusUnit::texel:
            return {settings.radius_texels, {0.5f, 4000, true, "%.1f texels"}};
        case RadiusUnit::world:
            break;
    }
    return {desk.session.brush().radius, {radius * 0.002f, radius * 2, true, "%.4g"}};
}

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

namespace {

// The settings of the bar, left to right; `rank`: what finds no room goes to the list behind *More*, from the
// greatest on, and labels are left out from the least on.
struct BarItem {
    const char* name;
    float width, least;  // points: beside its label, and without one
    int rank;
    void (*draw)(Desk& desk, bool labelled);
};

constexpr float kGap = 10;  // points before an item without a label

constexpr std::array kItems{
    BarItem{"Size", 130, 104, 2, size_slider},
    BarItem{"Strength", 110, 104, 3, strength_slider},
    BarItem{"Falloff", 96, 88, 4, [](Desk& desk, bool) { falloff_combo(desk); }},
    BarItem{"Method", 110, 102, 1, [](Desk& desk, bool) { method_combo(desk); }},
    BarItem{"View", 118, 88, 0, view_combo},
    BarItem{"Symmetry", 90, 84, 5, symmetry_buttons},
};
constexpr int kRanks = static_cast<int>(kItems.size());

const BarItem& item_of(int rank) {
    return *std::ranges::find(kItems, rank, &BarItem::rank);
}

// Ranks below `shown` find room, and those from `labelled` on find some for their labels as well.
struct Fit {
    int shown = 0, labelled = 0;
};

Fit fit_into(float room) {
    Fit fit;
    for (; fit.shown < kRanks; ++fit.shown) {
        const float need = points(kGap + item_of(fit.shown).least);
        if (need > room) break;
        room -= need;
    }
    for (fit.labelled = fit.shown; fit.labelled > 0; --fit.labelled) {
        const BarItem& item = item_of(fit.labelled - 1);
        room -= label_width(item.name) + points(item.width - item.least - kGap);
        if (room < 0) break;
    }
    return fit;
}

float more_width() {
    return points(kGap) + ImGui::CalcTextSize("More").x + 2 * ImGui::GetStyle().FramePadding.x;
}

// The settings that found no room, from the rank `shown` on; lit where one of them is on unseen.
void more_button(Desk& desk, int shown) {
    const Brush& brush = desk.session.brush();
    const auto hidden = [&](auto* draw) {
        return std::ranges::any_of(kItems,
                                   [&](const BarItem& i) { return i.draw == draw && i.rank >= shown; });
    };
    const bool lit = hidden(symmetry_buttons) && (brush.mirror_x || brush.mirror_y || brush.mirror_z);
    ImGui::SameLine(0, points(kGap));
    if (lit) ImGui::PushStyleColor(ImGuiCol_Button, kAccentDim);
    if (push_button("More", true, "Settings for which the bar has no room")) ImGui::OpenPopup("more");
    if (lit) ImGui::PopStyleColor();
    ImGui::SetNextWindowPos(ImGui::GetItemRectMax(), ImGuiCond_Always, {1, 0});
    end_list_in_window(ImGui::GetItemRectMax().y);
    if (!ImGui::BeginPopup("more")) return;
    for (const BarItem& item : kItems) {
        if (item.rank < shown) continue;
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", item.name);
        ImGui::SameLine(points(96));
        ImGui::SetNextItemWidth(points(item.width));
        item.draw(desk, true);
    }
    ImGui::EndPopup();
}

}  // namespace

void draw_top_bar(Desk& desk, const Box& box) {
    begin_panel("top", box, points(10), (static_cast<float>(box.height) - ImGui::GetFrameHeight()) / 2);
    file_buttons(desk);
    const float keys = static_cast<float>(box.width) - ImGui::CalcTextSize("Keys").x - points(28);
    const float room = keys - ImGui::GetCursorPosX() - points(8);
    Fit fit = fit_into(room);
    const bool all = fit.shown == kRanks;
    if (!all) fit = fit_into(room - more_width());
    for (const BarItem& item : kItems) {
        if (item.rank >= fit.shown) continue;
        const bool labelled = item.rank >= fit.labelled;
        if (labelled)
            label(item.name);
        else
            ImGui::SameLine(0, points(kGap));
        ImGui::SetNextItemWidth(points(labelled ? item.width : item.least));
        item.draw(desk, labelled);
    }
    if (!all) more_button(desk, fit.shown);
    ImGui::SameLine(keys);
    if (push_button("Keys", true, "All keys and mouse buttons  (F1)")) desk.view.wanted = Dialog::keys;
    ImGui::End();
}

}  // namespace relievo::gui
