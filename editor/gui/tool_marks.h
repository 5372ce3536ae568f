// What stamp and clone show on the surface beside the brush's ring: the image's frame, and where relief comes
// from.
#pragma once

#include "editor/gui/live_picture.h"
#include "editor/session/session.h"

struct ImDrawList;

namespace relievo::gui {

class BrushCursor;

// `x`, `y`: the picture's corner on screen.
void draw_tool_marks(ImDrawList& list, const Session& session, const BrushCursor& cursor, PixelSize picture,
                     double x, double y);

}  // namespace relievo::gui
