// The bar at the bottom: what the tool does, the surface under the pointer, and what each stage took.
#include <imgui.h>

#include <string>

#include "editor/gui/panels.h"
#include "editor/gui/theme.h"
#include "editor/gui/tool_hint.h"
#include "editor/gui/widgets.h"
#include "editor/session/text.h"

namespace relievo::gui {
namespace {

std::string hint(const Desk& desk) {
    switch (desk.view.brush_drag) {
        case BrushDrag::radius:
            return "Move to size the brush, click to keep it, right-click or Esc to leave it as it was";
        case BrushDrag::strength:
            return "Move to set the strength, click to keep it, right-click or Esc to leave it as it was";
        case BrushDrag::rotation:
            return "Move to turn the image, click to keep it, right-click or Esc to leave it as it was";
        case BrushDrag::light:
            return "Move to turn lights and sky, click to keep it, right-click or Esc to leave it as it was";
        case BrushDrag::none:
            break;
    }
    if (desk.session.in_stroke()) return "Esc cancels the stroke";
    if (desk.view.asking) return "Click a pixel to list what its ray met; Esc ends it";
    return tool_hint(desk.session.brush());
}

double mebibytes(std::size_t bytes) {
    return static_cast<double>(bytes) / (1 << 20);
}

struct Item {
    std::string text, meaning;
    ImU32 colour = kTextDim;
};

// From right to left, so that the rightmost stay where they are.
// What finds no room is left out.
void draw_right(const Box& box, std::initializer_list<Item> items) {
    const float left = ImGui::GetItemRectMax().x + points(18);
    float x = static_cast<float>(box.width) - points(12);
    for (const Item& item : items) {
        if (item.text.empty()) continue;
        x -= ImGui::CalcTextSize(item.text.c_str()).x;
        if (x < left) return;
        ImGui::SameLine(x);
        ImGui::PushStyleColor(ImGuiCol_Text, item.colour);
        ImGui::TextUnformatted(item.text.c_str());
        ImGui::PopStyleColor();
        tooltip(item.meaning);
        x -= points(18);
    }
}

Item progress_item(const Desk& desk) {
    if (desk.live.view() == View::error && desk.live.progress() >= 1) {
        const double known = desk.live.reference_progress();
        if (known >= 1) return {"reference complete", "The error of every pixel is known."};
        return {formatted("reference %.0f%%", 100 * known),
                "Traced in double precision on the processor, beside your work; a change starts it anew."};
    }
    if (shows_layers(desk.live.view()))
        return {formatted("view %.0f%%", 100 * desk.live.progress()), "Camera rays traced of this view."};
    if (desk.live.samples() == 0)
        return {formatted("preview %.0f%%", 100 * desk.live.progress()), "Free of noise; samples follow."};
    return {formatted("%d / %d samples", desk.live.samples(), desk.live.sample_limit()),
            "Samples a pixel so far, and where the picture rests."};
}

Item surface_item(const Desk& desk) {
    const auto spot = desk.cursor.spot();
    if (!spot) return {};
    return {formatted("height %+.4g   map %.0f", spot->height, spot->counts),
            "Under the pointer: world units over the base surface; value of the map, 0 to 65535.", kText};
}

Item clip_item(const Desk& desk) {
    const std::size_t clipped = desk.session.clipped_texels();
    if (clipped == 0) return {};
    return {formatted("%zu texels at the map's limit", clipped),
            "The last stroke wanted to go further than 0 or 65535. Raise the amplitude for more room.",
            kWarning};
}

}  // namespace

void draw_status_bar(Desk& desk, const Box& box) {
    begin_panel("status", box, points(12), (static_cast<float>(box.height) - ImGui::GetTextLineHeight()) / 2);
    const bool unsaved = desk.session.unsaved();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float middle = at.y + ImGui::GetTextLineHeight() / 2;
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x + points(4), middle}, points(4),
                                                unsaved ? kAccent : kGood);
    ImGui::Dummy(ImVec2(points(10), ImGui::GetTextLineHeight()));
    tooltip(unsaved ? "The map has changes that are not saved." : "All is saved.");
    ImGui::SameLine();
    ImGui::TextUnformatted(hint(desk).c_str());
    const StageTimes& t = desk.session.times();
    const Item stages{
        formatted("edit %.1f  upload %.2f  bounds %.2f  trace %.0f ms", t.edit_ms, t.upload_ms,
                  t.bounds_ms + t.refit_ms, desk.live.trace_ms()),
        "Milliseconds by stage: the last dab's edit of the map, the upload of what a frame's dabs changed, the "
        "bounds of the touched triangles (refit included), and the last trace."};
    const Item memory{formatted("undo %.1f / %.0f MiB", mebibytes(desk.session.undo_bytes()),
                                mebibytes(desk.session.undo_budget())),
                      "Memory of the undo steps; beyond the budget, the oldest are dropped."};
    const std::string trouble = desk.session.journal_error();
    const Item journal{trouble.empty() ? "" : "journal incomplete", trouble, kError};
    draw_right(box, {journal, clip_item(desk), memory, stages, progress_item(desk), surface_item(desk)});
    ImGui::End();
}

}  // namespace relievo::gui
