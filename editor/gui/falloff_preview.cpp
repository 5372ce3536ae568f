// The brush's falloff as a profile through its middle, from rim to rim, hardness included. The custom one is
// drawn by hand here: its points can be dragged on either side.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "brushes/dab_tools.h"
#include "editor/gui/panels.h"
#include "editor/gui/theme.h"
#include "editor/gui/widgets.h"

namespace relievo::gui {
namespace {

constexpr float kHeight = 44, kHeightToDraw = 96, kMargin = 6;  // points
constexpr float kReach = 9;  // points from the pointer, within which it takes hold of the curve's

// Where the profile lies on the screen, pixels.
struct Profile {
    float left, span, floor, rise;

    ImVec2 place(float across, float weight) const { return {left + across * span, floor - weight * rise}; }
    // Of the curve's point, on the side -1 or 1 of the middle.
    ImVec2 place(const CurvePoint& point, float hardness, float side) const {
        const float part = hardness + point.part * (1 - hardness);
        return place(0.5f + side * 0.5f * part, point.weight);
    }
    CurvePoint curve_point(const ImVec2& at, float hardness) const {
        const float part = std::abs(2 * (at.x - left) / span - 1);
        return {std::clamp((part - hardness) / (1 - hardness), 0.0f, 1.0f), (floor - at.y) / rise};
    }
};

std::optional<std::size_t> point_near(const Brush& brush, const Profile& profile, const ImVec2& at) {
    std::optional<std::size_t> nearest;
    float least = points(kReach);
    const auto curve = brush.falloff_curve.points();
    for (std::size_t i = 0; i < curve.size(); ++i)
        for (const float side : {-1.0f, 1.0f}) {
            const ImVec2 place = profile.place(curve[i], brush.hardness, side);
            const float distance = std::hypot(place.x - at.x, place.y - at.y);
            if (distance < least) least = distance, nearest = i;
        }
    return nearest;
}

// After the button that the profile is.
void edit(Brush& brush, const Profile& profile) {
    constexpr int kNone = -1;
    int& held = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("held point"), kNone);
    FalloffCurve& curve = brush.falloff_curve;
    const ImGuiIO& io = ImGui::GetIO();
    const CurvePoint pointed = profile.curve_point(io.MousePos, brush.hardness);
    if (ImGui::IsItemActivated()) {
        auto taken = point_near(brush, profile, io.MousePos);
        held = kNone;
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            curve = FalloffCurve();
        } else if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
            if (taken) curve.remove(*taken);
        } else {
            if (!taken && (taken = curve.add(pointed.part))) curve.move(*taken, pointed);
            if (taken) held = static_cast<int>(*taken);
        }
    }
    const bool moved = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
    if (ImGui::IsItemActive() && held != kNone && moved) curve.move(static_cast<std::size_t>(held), pointed);
}

void draw_points(const Brush& brush, const Profile& profile, bool hot) {
    const auto near = hot ? point_near(brush, profile, ImGui::GetIO().MousePos) : std::nullopt;
    const auto curve = brush.falloff_curve.points();
    for (std::size_t i = 0; i < curve.size(); ++i)
        for (const float side : {-1.0f, 1.0f})
            ImGui::GetWindowDrawList()->AddCircleFilled(profile.place(curve[i], brush.hardness, side),
                                                        points(near == i ? 5.0f : 3.5f), kText);
}

}  // namespace

void draw_falloff_preview(Brush& brush) {
    const bool by_hand = brush.falloff == Falloff::custom;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = std::max(points(40), ImGui::GetContentRegionAvail().x);
    const float height = points(by_hand ? kHeightToDraw : kHeight), margin = points(kMargin);
    const Profile profile{corner.x + margin, width - 2 * margin, corner.y + height - margin,
                          height - 2 * margin};
    if (by_hand) {
        ImGui::InvisibleButton("##falloff profile", {width, height},
                               ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
        edit(brush, profile);
        if (!ImGui::IsItemActive())
            tooltip(
                "The weight from rim to rim of the brush. Drag its points; a click beside them adds one, a "
                "right "
                "click takes one away, a double click starts anew.",
                "Falloff");
    } else {
        ImGui::Dummy({width, height});
        tooltip(
            "The weight from rim to rim of the brush: falloff and hardness together. Custom is drawn by "
            "hand.",
            "Falloff");
    }
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(corner, {corner.x + width, corner.y + height}, kLine, points(3));
    // A column a pixel: a profile may have a step, at the rim of a constant or a hard one.
    ImVec2 before = profile.place(0, 0);
    const int columns = std::max(1, static_cast<int>(profile.span));
    for (int i = 0; i <= columns; ++i) {
        const float across = static_cast<float>(i) / static_cast<float>(columns);
        const ImVec2 now = profile.place(across, falloff_weight(brush, std::abs(2 * across - 1)));
        draw.AddLine({now.x, profile.floor}, now, kAccentDim);
        draw.AddLine(before, now, kAccent, points(1));
        before = now;
    }
    draw.AddLine(before, profile.place(1, 0), kAccent, points(1));
    if (by_hand) draw_points(brush, profile, ImGui::IsItemHovered());
}

}  // namespace relievo::gui
