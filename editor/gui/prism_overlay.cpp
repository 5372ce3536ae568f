// Draws the base mesh and its prisms over the picture.
#include "editor/gui/prism_overlay.h"

#include <imgui.h>

#include <array>
#include <cmath>

#include "editor/gui/theme.h"

namespace relievo::gui {
namespace {

struct Pen {
    ImU32 colour;  // without alpha
    float width;   // points
    float strength;
};
// base, cap, side
constexpr std::array kPens{Pen{IM_COL32(120, 205, 255, 0), 1.4f, 0.95f},
                           Pen{IM_COL32(255, 170, 80, 0), 1.0f, 0.75f},
                           Pen{IM_COL32(255, 215, 140, 0), 1.0f, 0.55f}};
constexpr float kFarthest = 0.3f;  // strength of what is farthest

}  // namespace

void PrismOverlay::draw(ImDrawList& list, const Session& session, const Box& box,
                        const std::optional<glm::dvec2>& pointer) {
    prisms_.follow(session);
    PrismLimits limits;
    limits.near_px = static_cast<double>(points(static_cast<float>(limits.near_px)));
    PrismView view = prisms_.view(session.scene(), {box.width, box.height}, pointer, limits);
    note_ = view.note;
    const ImVec2 corner(static_cast<float>(box.x), static_cast<float>(box.y));
    list.PushClipRect(corner,
                      {corner.x + static_cast<float>(box.width), corner.y + static_cast<float>(box.height)});
    for (const OverlayLine& line : view.lines) {
        const Pen& pen = kPens[static_cast<std::size_t>(line.kind)];
        const float alpha = pen.strength * (kFarthest + (1 - kFarthest) * line.nearness);
        const auto at = [&](const glm::dvec2& p) {
            return ImVec2(corner.x + static_cast<float>(p.x), corner.y + static_cast<float>(p.y));
        };
        const ImU32 colour = pen.colour | static_cast<ImU32>(std::lround(alpha * 255)) << IM_COL32_A_SHIFT;
        list.AddLine(at(line.a), at(line.b), colour, points(pen.width));
    }
    list.PopClipRect();
}

}  // namespace relievo::gui
