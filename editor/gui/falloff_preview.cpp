// The brush's falloff as a profile through its middle, from rim to rim, hardness included.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "brushes/dab_tools.h"
#include "editor/gui/panels.h"
#include "editor/gui/theme.h"
#include "editor/gui/widgets.h"

namespace relievo::gui {
namespace {

constexpr float kHeight = 44, kMargin = 4;  // points

}  // namespace

void draw_falloff_preview(const Brush& brush) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = std::max(points(40), ImGui::GetContentRegionAvail().x), height = points(kHeight);
    ImGui::Dummy({width, height});
    tooltip("The weight from rim to rim of the brush: falloff and hardness together.", "Falloff");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(corner, {corner.x + width, corner.y + height}, kLine, points(3));
    const float left = corner.x + points(kMargin), span = width - 2 * points(kMargin);
    const float floor = corner.y + height - points(kMargin), rise = height - 2 * points(kMargin);
    // A column a pixel: a profile may have a step, at the rim of a constant or a hard one.
    ImVec2 before{left, floor};
    const int columns = std::max(1, static_cast<int>(span));
    for (int i = 0; i <= columns; ++i) {
        const float across = static_cast<float>(i) / static_cast<float>(columns);
        const float weight = falloff_weight(brush.falloff, brush.hardness, std::abs(2 * across - 1));
        const ImVec2 now{left + across * span, floor - weight * rise};
        draw.AddLine({now.x, floor}, now, kAccentDim);
        draw.AddLine(before, now, kAccent, points(1));
        before = now;
    }
    draw.AddLine(before, {before.x, floor}, kAccent, points(1));
}

}  // namespace relievo::gui
