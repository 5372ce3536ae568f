// Where the fixed panels stand.
#include "editor/gui/layout.h"

#include <algorithm>

#include "editor/gui/theme.h"

namespace relievo::gui {

Layout make_layout(PixelSize window, bool interface_hidden, float& side_width) {
    Layout layout;
    const auto px = [](float value) { return static_cast<int>(points(value)); };
    if (interface_hidden) {
        layout.picture = {0, 0, window.width, window.height};
        return layout;
    }
    if (side_width <= 0) side_width = points(316);
    side_width =
        std::clamp(side_width, points(240), std::max(points(240), 0.5f * static_cast<float>(window.width)));
    const int top = px(46), status = px(28), tools = px(60), side = static_cast<int>(side_width);
    const int middle = std::max(1, window.height - top - status);
    layout.top = {0, 0, window.width, top};
    layout.status = {0, window.height - status, window.width, status};
    layout.tools = {0, top, tools, middle};
    layout.side = {window.width - side, top, side, middle};
    layout.picture = {tools, top, std::max(1, window.width - tools - side), middle};
    return layout;
}

}  // namespace relievo::gui
