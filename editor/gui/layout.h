// Where the fixed panels stand, and what is left for the picture. Pixels.
#pragma once

#include "editor/gui/window.h"

namespace relievo::gui {

struct Box {
    int x = 0, y = 0, width = 0, height = 0;
    bool holds(double px, double py) const { return px >= x && py >= y && px < x + width && py < y + height; }
};

struct Layout {
    Box picture, tools, top, side, status;
};

// `side_width` in pixels is brought into a sensible range. Hidden, the picture takes the whole window.
Layout make_layout(PixelSize window, bool interface_hidden, float& side_width);

}  // namespace relievo::gui
