// What the left button does with a brush, alone and with Ctrl or Shift held.
#pragma once

#include <string>

#include "brushes/brush.h"

namespace relievo::gui {

// One line for the status bar.
std::string tool_hint(const Brush& brush);

}  // namespace relievo::gui
