// Rows of a panel.
#include "editor/gui/widgets.h"

#include <imgui.h>

#include <string>

#include "editor/gui/theme.h"

namespace relievo::gui {
namespace {

constexpr float kLabelShare = 0.36f;  // of the row

std::string hidden_label(std::string_view label) {
    return "##" + std::string(label);
}

}  // namespace

void tooltip(std::string_view text, std::string_view title) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || (text.empty() && title.empty())) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(points(10), points(8)));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(points(320));
    if (!title.empty()) {
        ImGui::PushFont(strong_font());
        ImGui::TextUnformatted(title.data(), title.data() + title.size());
        ImGui::PopFont();
    }
    if (!text.empty()) ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

void row_label(std::string_view label) {
    const float start = ImGui::GetCursorPosX();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextUnformatted(label.data(), label.data() + label.size());
    ImGui::PopStyleColor();
    ImGui::SameLine(start + width * kLabelShare);
    ImGui::SetNextItemWidth(-1);
}

bool slider_row(std::string_view label, float& value, const Range& range, std::string_view text,
                std::string_view unit) {
    row_label(label);
    const ImGuiSliderFlags flags =
        ImGuiSliderFlags_AlwaysClamp | (range.logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    const std::string format = std::string(range.format) + (unit.empty() ? "" : " ") + std::string(unit);
    const bool changed = ImGui::SliderFloat(hidden_label(label).c_str(), &value, range.low, range.high,
                                            format.c_str(), flags);
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
    const bool changed = ImGui::ColorEdit3(hidden_label(label).c_str(), rgb,
                                           ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoOptions);
    tooltip(text, label);
    return changed;
}

void text_row(std::string_view label, std::string_view value) {
    row_label(label);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(value.data(), value.data() + value.size());
    ImGui::PopTextWrapPos();
}

bool section(const char* title) {
    ImGui::PushFont(strong_font());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(points(8), points(6)));
    const bool open = ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    return open;
}

bool push_button(const char* label, bool enabled, std::string_view text) {
    ImGui::BeginDisabled(!enabled);
    const bool pushed = ImGui::Button(label);
    ImGui::EndDisabled();
    tooltip(text);
    return pushed;
}

}  // namespace relievo::gui
