// The panels around the picture, each in its own file. They read the session, change what is only view state,
// and give every other change to the desk.
#pragma once

#include "editor/gui/desk.h"
#include "editor/gui/layout.h"
#include "editor/gui/widgets.h"

namespace relievo::gui {

void draw_tool_column(Desk& desk, const Box& box);
void draw_top_bar(Desk& desk, const Box& box);
void draw_side_panel(Desk& desk, const Box& box);
void draw_status_bar(Desk& desk, const Box& box);

// Sections of the side panel.
void draw_brush_section(Desk& desk);
void draw_falloff_preview(Brush& brush);  // where the custom one is drawn, too
void draw_alpha_picker(Desk& desk);  // rows of it, for the stamp
void draw_colour_rows(Desk& desk);  // of the brush section: painting
void draw_map_section(Desk& desk);
void draw_source_section(Desk& desk);  // where the heights are procedural
void draw_method_section(Desk& desk);
void draw_lights_section(Desk& desk);
void draw_render_section(Desk& desk);

// Begins the fixed window of a panel; pair with ImGui::End().
void begin_panel(const char* name, const Box& box, float pad_x, float pad_y);

// The brush's size in its unit, and its range.
struct SizeSetting {
    float& value;
    Range range;
};
SizeSetting size_setting(Desk& desk);
// Combos that the top bar and the side panel share; the width is the item width set before.
void falloff_combo(Desk& desk);
void method_combo(Desk& desk);

}  // namespace relievo::gui
