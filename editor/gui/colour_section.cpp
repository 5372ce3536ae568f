// Rows of the brush section about painting: what the tool changes, the colour, the colours used before, and
// the map that they go to.
#include <imgui.h>

#include <string>

#include "editor/gui/panels.h"
#include "editor/gui/theme.h"
#include "editor/gui/widgets.h"

namespace relievo::gui {
namespace {

void paint_row(Brush& brush) {
    row_label("Paint");
    const auto names = paint_names();
    const auto now = static_cast<std::size_t>(brush.paint);
    if (ImGui::BeginCombo("##paint", std::string(names[now]).c_str())) {
        for (std::size_t i = 0; i < names.size(); ++i)
            if (ImGui::Selectable(std::string(names[i]).c_str(), i == now))
                brush.paint = static_cast<Paint>(i);
        ImGui::EndCombo();
    }
    tooltip("What the tool changes: heights, colours, or both. P goes through the three.", "Paint");
}

void colour_row(Brush& brush) {
    row_label("Colour");
    float rgb[3] = {brush.red, brush.green, brush.blue};
    if (color_edit("##paint colour", rgb, ImGuiColorEditFlags_PickerHueBar))
        set_colour(brush, {rgb[0], rgb[1], rgb[2]});
    tooltip("sRGB, 0 to 255. A click on the patch opens the picker; S takes the colour under the pointer.",
            "Colour");
}

void recent_row(Desk& desk) {
    if (desk.view.recent_colours.empty()) return;
    row_label("Recent");
    for (std::size_t i = 0; i < desk.view.recent_colours.size(); ++i) {
        const PaintColour colour = desk.view.recent_colours[i];
        ImGui::PushID(static_cast<int>(i));
        if (i > 0) ImGui::SameLine(0, points(4));
        if (ImGui::ColorButton("##recent", {colour[0], colour[1], colour[2], 1}, ImGuiColorEditFlags_NoAlpha,
                               {points(16), points(16)}))
            set_colour(desk.session.brush(), colour);
        ImGui::PopID();
    }
}

void map_row(Desk& desk) {
    row_label("Colour map");
    if (const ColourMap* map = desk.session.colours()) {
        ImGui::Text("%d x %d, %d bit", map->width(), map->height(), map->bits());
        return;
    }
    const int now = desk.view.colour_bits;
    for (const int bits : {8, 16}) {
        if (bits > 8) ImGui::SameLine(0, points(4));
        if (ImGui::RadioButton((std::to_string(bits) + " bit").c_str(), now == bits))
            desk.view.colour_bits = bits;
        tooltip(
            "The first stroke that paints makes a colour map of the map's size, filled with the material's "
            "albedo.",
            "New colour map");
    }
}

}  // namespace

void draw_colour_rows(Desk& desk) {
    Brush& brush = desk.session.brush();
    if (!holds(kPaintingTools, brush.tool)) return;
    paint_row(brush);
    if (!paints(brush)) return;
    if (holds(kColouringTools, brush.tool)) {
        colour_row(brush);
        recent_row(desk);
    }
    map_row(desk);
}

}  // namespace relievo::gui
