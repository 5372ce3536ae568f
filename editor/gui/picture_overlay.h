// What stands over the picture but is no part of it: the names and times of its halves, the divider, the
// colour bar of a view.
#pragma once

#include "editor/gui/desk.h"
#include "editor/gui/layout.h"

namespace relievo::gui {

// `pointer_on_divider`: it is lit then.
void draw_picture_overlay(Desk& desk, const Box& picture, bool pointer_on_divider);

// Beside the pointer at (x, y), window pixels: what F, Shift+F and Alt+F are changing. A hidden interface shows it
// nowhere else.
void draw_dragged_value(Desk& desk, const Box& picture, double x, double y);

// What a newcomer needs for a first stroke, in three lines.
void draw_first_hint(const Box& picture);

// Whether a press at (x, y), pixels of the picture, takes the divider.
bool on_divider(const Desk& desk, double x);

}  // namespace relievo::gui
