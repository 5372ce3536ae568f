// What stands over the picture but is no part of it.
#include "editor/gui/picture_overlay.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "editor/gui/panels.h"
#include "editor/gui/theme.h"
#include "editor/session/text.h"
#include "renderer/methods/registry.h"

namespace relievo::gui {
namespace {

constexpr ImU32 kPlate = IM_COL32(24, 26, 30, 214);
constexpr ImU32 kPlateEdge = IM_COL32(255, 255, 255, 26);
constexpr int kBarSteps = 96;
constexpr float kGripPoints = 5;

ImU32 packed(const Rgb& c) {
    return IM_COL32(c.r, c.g, c.b, 255);
}

void wrapped_text(ImDrawList& list, ImVec2 at, ImU32 colour, const char* text, float width) {
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), at, colour, text, nullptr, width);
}

ImVec2 wrapped_size(const char* text, float width) {
    return ImGui::CalcTextSize(text, nullptr, false, width);
}

// Text on a plate, its top left corner at `at`, which is at most so wide; returns the plate's lower right corner.
ImVec2 plate(ImDrawList& list, ImVec2 at, const std::string& text, ImU32 colour, float width) {
    const float x = points(8), y = points(4), most = std::max(1.0f, width - 2 * x);
    const ImVec2 size = wrapped_size(text.c_str(), most);
    const ImVec2 end(at.x + size.x + 2 * x, at.y + size.y + 2 * y);
    list.AddRectFilled(at, end, kPlate, points(4));
    list.AddRect(at, end, kPlateEdge, points(4));
    wrapped_text(list, {at.x + x, at.y + y}, colour, text.c_str(), most);
    return end;
}

std::string milliseconds(double ms) {
    char text[32];
    std::snprintf(text, sizeof text, ms < 10 ? "%.1f ms" : "%.0f ms", ms);
    return text;
}

std::string error_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, value < 0.01 ? "%.1e" : "%.2g", value);
    return text;
}

std::string error_text(const ErrorSummary& errors, bool complete) {
    if (errors.pixels + errors.missed + errors.invented == 0) return {};
    std::string text = (complete ? "" : "so far   ") + ("median " + error_number(errors.median)) + "   p99 " +
                       error_number(errors.p99);
    if (complete)
        text += "   max " + error_number(errors.largest) + "   missed " + std::to_string(errors.missed) +
                "   invented " + std::to_string(errors.invented);
    return text;
}

// Name and time of a pane; below, what its view sums up. Kept within the pane's columns.
void pane_label(ImDrawList& list, Desk& desk, std::size_t pane, float left, float right, float top) {
    const MethodChoice& choice = pane == 0 ? desk.session.scene().method : desk.view.second;
    std::string text(find_method(choice.name).name);
    const double ms = desk.live.pass_ms(pane);
    const bool light = !shows_layers(desk.live.view());
    if (ms > 0) text += "   " + milliseconds(ms) + (light ? " a pass" : ", camera rays");
    list.PushClipRect({left, top}, {right, top + points(200)}, true);
    const float width = right - left - points(24);
    const ImVec2 end = plate(list, {left + points(12), top + points(12)}, text, kText, width);
    if (desk.live.view() == View::error) {
        const std::string errors = error_text(desk.live.errors(pane), desk.live.reference_progress() >= 1);
        if (!errors.empty()) plate(list, {left + points(12), end.y + points(4)}, errors, kTextDim, width);
    }
    list.PopClipRect();
}

void divider(ImDrawList& list, const Box& picture, float x, bool lit) {
    const float top = static_cast<float>(picture.y), bottom = top + static_cast<float>(picture.height);
    const float middle = (top + bottom) / 2;
    list.AddLine({x, top}, {x, bottom}, kRingShadow, points(3));
    list.AddLine({x, top}, {x, bottom}, lit ? kAccent : kRing, points(1));
    list.AddRectFilled({x - points(5), middle - points(18)}, {x + points(5), middle + points(18)}, kPlate,
                       points(5));
    for (const float dx : {-1.5f, 1.5f})
        list.AddLine({x + points(dx), middle - points(8)}, {x + points(dx), middle + points(8)},
                     lit ? kAccent : kRing, points(1));
}

std::string bar_title(const LivePicture& live) {
    switch (live.view()) {
        case View::height:
            return "Height over the base mesh, world units";
        case View::steps:
            return "Camera ray: " + std::string(ray_counts()[static_cast<std::size_t>(live.count())].name);
        case View::error:
            return "Depth error over amplitude";
        case View::beauty:
        case View::normals:
        case View::prisms:
            break;
    }
    return {};
}

struct Swatch {
    Rgb colour;
    const char* text;
};
constexpr std::array kSwatches{Swatch{kMissed, "missed"}, Swatch{kInvented, "invented"},
                               Swatch{kNotKnown, "not known yet"}};

// In rows of at most that width; returns their height. Without a list they are only measured.
float swatches(ImDrawList* list, ImVec2 at, float width) {
    const float side = points(10), left = at.x, top = at.y, line = ImGui::GetTextLineHeight();
    for (const Swatch& swatch : kSwatches) {
        const float need = side + points(5) + ImGui::CalcTextSize(swatch.text).x;
        if (at.x > left && at.x + need > left + width) at = {left, at.y + line + points(3)};
        const float middle = at.y + (line - side) / 2;
        if (list != nullptr) {
            list->AddRectFilled({at.x, middle}, {at.x + side, middle + side}, packed(swatch.colour), points(2));
            list->AddText({at.x + side + points(5), at.y}, kTextDim, swatch.text);
        }
        at.x += need + points(12);
    }
    return at.y + line - top;
}

void ticks(ImDrawList& list, const std::vector<Tick>& all, float left, float width, float y) {
    float taken = left - width;  // by the numbers so far
    for (const Tick& tick : all) {
        const float x = left + width * static_cast<float>(tick.share);
        const float half = ImGui::CalcTextSize(tick.text.c_str()).x / 2;
        list.AddLine({x, y - points(4)}, {x, y}, kText, points(1));
        const float at = std::clamp(x - half, left - points(4), left + width + points(4) - 2 * half);
        if (at < taken) continue;
        list.AddText({at, y + points(1)}, kTextDim, tick.text.c_str());
        taken = at + 2 * half + points(4);
    }
}

// In the lower right corner of the picture.
void colour_bar(ImDrawList& list, const LivePicture& live, const Box& picture) {
    const std::string title = bar_title(live);
    if (title.empty()) return;
    const bool error = live.view() == View::error;
    const float line = ImGui::GetTextLineHeight(), pad = points(10), bar = points(12), gap = points(5);
    const float width = std::min(points(320), static_cast<float>(picture.width) - points(24) - 2 * pad);
    if (width < points(120)) return;
    const float heading = wrapped_size(title.c_str(), width).y;
    const float legend = error ? gap + swatches(nullptr, {0, 0}, width) : 0;
    const float height = 2 * pad + heading + gap + bar + points(5) + line + legend;
    const ImVec2 end(static_cast<float>(picture.x + picture.width) - points(12),
                     static_cast<float>(picture.y + picture.height) - points(12));
    const ImVec2 low(end.x - width - 2 * pad, end.y - height);
    list.AddRectFilled(low, end, kPlate, points(5));
    list.AddRect(low, end, kPlateEdge, points(5));
    wrapped_text(list, {low.x + pad, low.y + pad}, kText, title.c_str(), width);
    const float left = low.x + pad, top = low.y + pad + heading + gap;
    for (int i = 0; i < kBarSteps; ++i) {
        const auto x = [&](int step) { return left + width * static_cast<float>(step) / kBarSteps; };
        const Rgb colour = live.scale().colour_at((i + 0.5) / kBarSteps);
        list.AddRectFilled({std::floor(x(i)), top}, {std::floor(x(i + 1)), top + bar}, packed(colour));
    }
    ticks(list, live.scale().ticks(), left, width, top + bar + points(4));
    if (error) swatches(&list, {left, top + bar + points(5) + line + gap}, width);
}

void note(ImDrawList& list, const std::string& text, const Box& picture) {
    if (text.empty()) return;
    const float most = static_cast<float>(picture.width) - points(24);
    const ImVec2 size = wrapped_size(text.c_str(), std::max(1.0f, most - points(16)));
    plate(list,
          {static_cast<float>(picture.x + picture.width) - size.x - points(28),
           static_cast<float>(picture.y + picture.height) - size.y - points(20)},
          text, kTextDim, most);
}

std::string dragged_value(Desk& desk) {
    const Brush& brush = desk.session.brush();
    switch (desk.view.brush_drag) {
        case BrushDrag::radius: {
            const SizeSetting size = size_setting(desk);
            return "size " + formatted(size.range.format, static_cast<double>(size.value));
        }
        case BrushDrag::strength:
            return formatted("strength %.2f", static_cast<double>(brush.strength));
        case BrushDrag::rotation:
            return formatted("%.0f degrees", static_cast<double>(brush.rotation));
        case BrushDrag::light:
        case BrushDrag::none:
            break;
    }
    return {};
}

}  // namespace

void draw_dragged_value(Desk& desk, const Box& picture, double x, double y) {
    const std::string text = dragged_value(desk);
    if (text.empty()) return;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float width = size.x + points(17), height = size.y + points(8);
    // Below and right of the pointer; the picture holds all of it where the pointer is near an edge or has left.
    const auto within = [](double at, int low, int extent, float own) {
        const auto first = static_cast<float>(low);
        return std::clamp(static_cast<float>(at) + points(18), first,
                          std::max(first, first + static_cast<float>(extent) - own));
    };
    plate(*ImGui::GetBackgroundDrawList(),
          {within(x, picture.x, picture.width, width), within(y, picture.y, picture.height, height)}, text, kText,
          width);
}

bool on_divider(const Desk& desk, double x) {
    return desk.live.is_split() &&
           std::abs(x - desk.live.divider_px()) <= static_cast<double>(points(kGripPoints));
}

void draw_first_hint(const Box& picture) {
    constexpr std::array kLines{"Drag over the surface to raise it. Ctrl lowers, Shift smooths.",
                                "Alt + drag turns it, the wheel zooms, 1 to 9 change the tool.",
                                "Ctrl + Z undoes. F1 lists every key."};
    const float pad = points(14), gap = ImGui::GetStyle().ItemSpacing.y;
    const float most = std::max(1.0f, static_cast<float>(picture.width) - 2 * pad);
    ImVec2 size(0, 0);
    for (const char* line : kLines) {
        const ImVec2 text = wrapped_size(line, most);
        size = {std::max(size.x, text.x), size.y + text.y + gap};
    }
    const float left = static_cast<float>(picture.x) + (static_cast<float>(picture.width) - size.x) / 2;
    const float top = static_cast<float>(picture.y) + points(16);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled({left - pad, top}, {left + size.x + pad, top + size.y + pad}, kPlate, points(6));
    float y = top + pad * 0.7f;
    for (const char* line : kLines) {
        wrapped_text(list, {left, y}, kText, line, most);
        y += wrapped_size(line, most).y + gap;
    }
}

void draw_picture_overlay(Desk& desk, const Box& picture, bool pointer_on_divider) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const LivePicture& live = desk.live;
    const float left = static_cast<float>(picture.x), right = left + static_cast<float>(picture.width);
    const float top = static_cast<float>(picture.y);
    const float middle = left + static_cast<float>(live.divider_px());
    if (live.is_split()) divider(list, picture, middle, pointer_on_divider);
    if (live.is_split() || live.view() == View::error) pane_label(list, desk, 0, left, middle, top);
    if (live.is_split()) pane_label(list, desk, 1, middle, right, top);
    if (shows_layers(live.view())) colour_bar(list, live, picture);
    if (live.view() == View::prisms) note(list, desk.prisms.note(), picture);
}

}  // namespace relievo::gui
