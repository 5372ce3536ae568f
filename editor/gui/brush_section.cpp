// The side panel's section about the brush: every setting of the tables that its tool reads.
#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include "editor/gui/panels.h"
#include "editor/gui/widgets.h"

namespace relievo::gui {
namespace {

// What a user calls a setting of a table.
std::string readable(std::string_view name) {
    std::string text(name);
    if (name == "lazy_px") text = "lazy";
    if (name.ends_with("_by_pressure"))  // the label's column is narrow
        text = "pen " + text.substr(0, text.find("_by_pressure"));
    if (name == "pressure_curve") text = "pen curve";
    std::replace(text.begin(), text.end(), '_', ' ');
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

template <typename Choice>
void choice_row(const char* label, std::span<const std::string_view> names, Choice& now,
                std::string_view text) {
    row_label(label);
    const auto index = static_cast<std::size_t>(now);
    if (ImGui::BeginCombo((std::string("##") + label).c_str(), std::string(names[index]).c_str())) {
        for (std::size_t i = 0; i < names.size(); ++i)
            if (ImGui::Selectable(std::string(names[i]).c_str(), i == index)) now = static_cast<Choice>(i);
        ImGui::EndCombo();
    }
    tooltip(text, label);
}

void size_rows(Desk& desk) {
    StrokeSettings& settings = desk.session.stroke_settings();
    choice_row("Unit", radius_unit_names(), settings.unit,
               "What the size counts: world units, pixels on the screen, or texels of the map.");
    const auto [value, range] = size_setting(desk);
    slider_row("Size", value, range, "Reach of the brush on the displaced surface, in that unit.");
}

void brush_rows(Desk& desk) {
    Brush& brush = desk.session.brush();
    for (const BrushParameter& parameter : brush_parameters()) {
        const bool has_own_row = parameter.name == "radius" || parameter.unit == "sRGB";
        if (has_own_row || !holds(parameter.tools, brush.tool)) continue;
        const bool whole = parameter.high - parameter.low > 20;
        float& value = brush.*parameter.value;
        const Range range{parameter.low, parameter.high, false, whole ? "%.0f" : "%.3f"};
        if (slider_row(readable(parameter.name), value, range, parameter.tooltip) && whole)
            value = std::round(value);
    }
    if (brush.radial > 1)
        choice_row("Radial axis", axis_names(), brush.radial_axis,
                   "The object's axis that the copies go about.");
    if (brush.tool == Tool::erase)
        choice_row(
            "Erase to", erase_to_names(), brush.erase_to,
            "midlevel: no displacement at all. saved: the map as it was last saved or, before that, opened.");
    for (const BrushFlag& flag : brush_flags())
        if (holds(flag.tools, brush.tool)) switch_row(readable(flag.name), brush.*flag.value, flag.tooltip);
}

// `own`: the settings of the tool alone, in the place of those that every tool has.
void stroke_rows(Desk& desk, bool own) {
    StrokeSettings& settings = desk.session.stroke_settings();
    const auto shown = [&](ToolSet tools) {
        return own == (tools != kEveryTool) && holds(tools, desk.session.brush().tool);
    };
    for (const StrokeParameter& parameter : stroke_parameters()) {
        const bool is_size = parameter.value == &StrokeSettings::radius_px ||
                             parameter.value == &StrokeSettings::radius_texels;  // in the row of its own
        if (is_size || !shown(parameter.tools)) continue;
        const bool decades = parameter.low > 0 && parameter.high / parameter.low > 50;
        const Range range{parameter.low, parameter.high, decades, parameter.high > 20 ? "%.0f" : "%.2f"};
        slider_row(readable(parameter.name), settings.*parameter.value, range, parameter.tooltip);
    }
    for (const StrokeFlag& flag : stroke_flags())
        if (shown(flag.tools)) switch_row(readable(flag.name), settings.*flag.value, flag.tooltip);
}

void mask_row(Desk& desk) {
    row_label("Mask");
    const auto names = mask_commands();
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto command = static_cast<MaskCommand>(i);
        const bool can = desk.session.mask() != nullptr || command == MaskCommand::invert;
        if (i > 0) ImGui::SameLine();
        if (push_button(readable(names[i]).c_str(), can,
                        "Of the whole mask, which protects from every tool. Undo takes it back."))
            desk.change_mask(command);
    }
}

}  // namespace

void draw_brush_section(Desk& desk) {
    if (!section("Brush")) return;
    if (desk.session.brush().tool == Tool::stamp) draw_alpha_picker(desk);
    stroke_rows(desk, true);
    size_rows(desk);
    draw_colour_rows(desk);
    brush_rows(desk);
    row_label("Falloff");
    falloff_combo(desk);
    draw_falloff_preview(desk.session.brush());
    stroke_rows(desk, false);
    mask_row(desk);
}

}  // namespace relievo::gui
