// Rows of a panel.
#include "editor/gui/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "editor/gui/theme.h"

namespace relievo::gui {
namespace {

constexpr float kLabelShare = 0.38f;  // of the row
constexpr float kDialogButton = 120;  // points

std::string hidden_label(std::string_view label) {
    return "##" + std::string(label);
}

}  // namespace

void tooltip(std::string_view text, std::string_view title) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || (text.empty() && title.empty())) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(points(10), points(8)));
    ImGui::BeginTooltip();
    ImGui::PushStyleColor(ImGuiCol_Text, kText);  // its control's may be another
    ImGui::PushTextWrapPos(points(320));
    if (!title.empty()) {
        ImGui::PushFont(strong_font());
        ImGui::TextUnformatted(title.data(), title.data() + title.size());
        ImGui::PopFont();
    }
    if (!text.empty()) ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

void row_label(std::string_view label) {
    const float start = ImGui::GetCursorPosX();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushClipRect(at, {at.x + width * kLabelShare - points(4), at.y + ImGui::GetFrameHeight()}, true);
    ImGui::TextUnformatted(label.data(), label.data() + label.size());
    ImGui::PopClipRect();
    ImGui::PopStyleColor();
    ImGui::SameLine(start + width * kLabelShare);
    ImGui::SetNextItemWidth(-1);
}

bool bar_slider(const char* label, float& value, const Range& range, const char* format) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::CalcItemWidth(), height = ImGui::GetFrameHeight();
    const bool logs = range.logarithmic && range.low > 0 && value > 0;
    const float share = logs ? std::log(value / range.low) / std::log(range.high / range.low)
                             : (value - range.low) / (range.high - range.low);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 high(low.x + width, low.y + height);
    const bool hot = ImGui::IsMouseHoveringRect(low, high);
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), ImGui::GetStyle().FrameRounding);
    const float filled = low.x + width * std::clamp(share, 0.0f, 1.0f);
    list.PushClipRect(low, {filled, high.y}, true);
    list.AddRectFilled(low, high, hot ? kBarHot : kBar, ImGui::GetStyle().FrameRounding);
    list.PopClipRect();
    // Dear ImGui's slider with nothing of its own but the number.
    for (const ImGuiCol part : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
                                ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive})
        ImGui::PushStyleColor(part, 0);
    const bool changed = ImGui::SliderFloat(
        label, &value, range.low, range.high, format,
        ImGuiSliderFlags_AlwaysClamp | (range.logarithmic ? ImGuiSliderFlags_Logarithmic : 0));
    ImGui::PopStyleColor(5);
    return changed;
}

bool slider_row(std::string_view label, float& value, const Range& range, std::string_view text,
                std::string_view unit) {
    row_label(label);
    const std::string format = std::string(range.format) + (unit.empty() ? "" : " ") + std::string(unit);
    const bool changed = bar_slider(hidden_label(label).c_str(), value, range, format.c_str());
    tooltip(std::string(text) + "\nCtrl+click to type a value.", label);
    return changed;
}

bool switch_row(std::string_view label, bool& value, std::string_view text) {
    row_label(label);
    const bool changed = ImGui::Checkbox(hidden_label(label).c_str(), &value);
    tooltip(text, label);
    return changed;
}

bool color_row(std::string_view label, float (&rgb)[3], std::string_view text) {
    row_label(label);
    const bool changed = color_edit(hidden_label(label).c_str(), rgb, ImGuiColorEditFlags_Float);
    tooltip(text, label);
    return changed;
}

bool color_edit(const char* label, float (&rgb)[3], int flags) {
    ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImGui::GetMainViewport()->Size);
    return ImGui::ColorEdit3(label, rgb, flags | ImGuiColorEditFlags_NoOptions);
}

void text_row(std::string_view label, std::string_view value) {
    row_label(label);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(value.data(), value.data() + value.size());
    ImGui::PopTextWrapPos();
}

std::string fitting_end(std::string_view path, float room, const std::function<float(std::string_view)>& width_of) {
    if (width_of(path) <= room) return std::string(path);
    constexpr std::string_view kCut = "...";
    const auto within_a_letter = [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; };
    std::string shown(kCut);
    do {
        path.remove_prefix(1);
        while (!path.empty() && within_a_letter(path.front())) path.remove_prefix(1);
        shown = std::string(kCut) + std::string(path);
    } while (!path.empty() && width_of(shown) > room);
    return shown;
}

float text_width(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

void path_text(const std::string& path) {
    const std::string shown = fitting_end(path, ImGui::GetContentRegionAvail().x, text_width);
    ImGui::TextDisabled("%s", shown.c_str());
    if (shown != path) tooltip(path);
}

bool path_input(const char* label, std::string& path) {
    const ImVec2 low = ImGui::GetCursorScreenPos(), pad = ImGui::GetStyle().FramePadding;
    const std::string shown = fitting_end(path, ImGui::CalcItemWidth() - 2 * pad.x, text_width);
    const bool idle = ImGui::GetActiveID() != ImGui::GetID(label);
    // Dear ImGui's field shows the start until it is being edited.
    const bool end_only = idle && shown != path;
    if (end_only) ImGui::PushStyleColor(ImGuiCol_Text, 0);
    const bool changed = ImGui::InputText(label, &path, ImGuiInputTextFlags_AutoSelectAll);
    if (end_only) {
        ImGui::PopStyleColor();
        ImGui::GetWindowDrawList()->AddText({low.x + pad.x, low.y + pad.y}, ImGui::GetColorU32(ImGuiCol_Text),
                                            shown.c_str());
    }
    return changed;
}

bool section(const char* title) {
    ImGui::PushFont(strong_font());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(points(8), points(6)));
    const bool open = ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    return open;
}

bool begin_modal(const char* title, float width, bool* keep) {
    const ImVec2 most = ImGui::GetMainViewport()->Size;
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSize(ImVec2(std::min(points(width), most.x), 0));
    ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), most);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(points(18), points(14)));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, points(6));
    const bool open = ImGui::BeginPopupModal(
        title, keep, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar(2);
    return open;
}

bool push_button(const char* label, bool enabled, std::string_view text) {
    ImGui::BeginDisabled(!enabled);
    const bool pushed = ImGui::Button(label);
    ImGui::EndDisabled();
    tooltip(text);
    return pushed;
}

namespace {

bool is_dialog(const ImGuiPopupData& popup) {
    return popup.Window != nullptr && (popup.Window->Flags & ImGuiWindowFlags_Modal);
}

bool escape_key() {
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
}

}  // namespace

bool escape_pressed() {
    const auto& open = ImGui::GetCurrentContext()->OpenPopupStack;
    const bool list_over_dialog = !open.empty() && is_dialog(open.front()) && !is_dialog(open.back());
    return escape_key() && !list_over_dialog;
}

void close_list_on_escape() {
    const auto& open = ImGui::GetCurrentContext()->OpenPopupStack;
    if (escape_key() && !open.empty() && open.back().Window != nullptr && !is_dialog(open.back()))
        ImGui::ClosePopupToLevel(open.Size - 1, true);
}

void keep_lists_in_window() {
    const ImVec2 most = ImGui::GetMainViewport()->Size;
    const auto within = [](float at, float size, float room) { return std::clamp(at, 0.0f, std::max(0.0f, room - size)); };
    for (const ImGuiPopupData& popup : ImGui::GetCurrentContext()->OpenPopupStack) {
        if (popup.Window == nullptr || is_dialog(popup)) continue;
        const ImVec2 at = popup.Window->Pos, size = popup.Window->Size;
        ImGui::SetWindowPos(popup.Window, ImVec2(within(at.x, size.x, most.x), within(at.y, size.y, most.y)));
    }
}

void keep_folded_while_scrolling() {
    ImGuiContext& ui = *ImGui::GetCurrentContext();
    bool& at_rest = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("at rest"));
    const bool moved = ui.IO.MouseDelta.x != 0 || ui.IO.MouseDelta.y != 0 || ImGui::IsMouseClicked(ImGuiMouseButton_Left) ||
                       ImGui::IsWindowAppearing();
    at_rest = !moved && (at_rest || (ui.IO.MouseWheel != 0 && ImGui::GetScrollMaxY() > 0));
    if (at_rest) ui.NavDisableMouseHover = true;  // for this frame
}

void end_list_in_window(float top) {
    const ImVec2 most = ImGui::GetMainViewport()->Size;
    ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(most.x, most.y - top));
}

bool dialog_button(const char* label, bool suggested) {
    if (suggested) ImGui::PushStyleColor(ImGuiCol_Button, kAccentDim);
    const bool pushed = ImGui::Button(label, ImVec2(points(kDialogButton), 0));
    if (suggested) ImGui::PopStyleColor();
    return pushed || (suggested && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter)));
}

void beside_dialog_button() {
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < points(kDialogButton)) ImGui::NewLine();
}

void note(std::string_view text) {
    ImGui::PushStyleColor(ImGuiCol_Text, kWarning);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.empty() ? " " : text.data(),
                           text.empty() ? nullptr : text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

}  // namespace relievo::gui
