// Pressure of pens and of whatever else has it, on X11 through XInput2.
#pragma once

#include <memory>

#include "editor/gui/pen_track.h"

struct GLFWwindow;

namespace relievo::gui {

// Null where the window is not X11's, or its server has no XInput2: then everything presses fully.
std::unique_ptr<PenReader> open_xinput_pen(GLFWwindow* window);

}  // namespace relievo::gui
