// The panel "why this pixel".
#include "editor/gui/ray_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "editor/gui/theme.h"
#include "editor/gui/widgets.h"
#include "editor/session/view_window.h"

namespace relievo::gui {
namespace {

constexpr std::array<const char*, 5> kColumns{"what", "t", "texel", "height", "reach"};

std::string number(const char* format, float value) {
    char text[48];
    std::snprintf(text, sizeof text, format, static_cast<double>(value));
    return text;
}

// A note as the cells of a row.
std::array<std::string, 5> cells_of(const TraceNote& note) {
    using Kind = TraceNote::Kind;
    std::array<std::string, 5> cells{"", number("%.7g", note.t),
                                     number("%.2f, ", note.texel.x) + number("%.2f", note.texel.y),
                                     note.kind == Kind::root ? "" : number("%+.4g", note.height), ""};
    switch (note.kind) {
        case Kind::box:
            cells[0] = "box";
            break;
        case Kind::step:
            cells[0] = note.extent > 0 ? "stretch" : "sample";
            if (note.extent > 0) cells[4] = number("%.3g texels", note.extent);
            break;
        case Kind::cell:
            cells[0] = "cell";
            cells[4] = number("to t %.7g", note.extent);
            break;
        case Kind::root:
            cells[0] = "root";
            break;
        case Kind::hit:
            cells[0] = "hit";
            break;
    }
    return cells;
}

ImU32 colour_of(const TraceNote& note) {
    switch (note.kind) {
        case TraceNote::Kind::hit:
            return kGood;
        case TraceNote::Kind::root:
            return kAccent;
        case TraceNote::Kind::cell:
            return kText;
        default:
            return kTextDim;
    }
}

void draw_notes(const std::vector<TraceNote>& notes) {
    const auto flags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoHostExtendX;
    if (!ImGui::BeginTable("notes", static_cast<int>(kColumns.size()), flags)) return;
    constexpr std::array<float, 5> kWidths{54, 76, 122, 80, 96};  // points; fixed, because rows are clipped
    for (std::size_t i = 0; i < kColumns.size(); ++i)
        ImGui::TableSetupColumn(kColumns[i], ImGuiTableColumnFlags_WidthFixed, points(kWidths[i]));
    ImGui::TableHeadersRow();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(notes.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const TraceNote& note = notes[static_cast<std::size_t>(i)];
            ImGui::TableNextRow();
            ImGui::PushStyleColor(ImGuiCol_Text, colour_of(note));
            for (const std::string& cell : cells_of(note)) {
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(cell.c_str());
            }
            ImGui::PopStyleColor();
        }
    }
    ImGui::EndTable();
}

}  // namespace

void RayPanel::ask(Renderer& renderer, LiveReference& reference, const std::string& method,
                   const glm::ivec2& pixel) {
    const bool was_open = is_open();
    report_ = report_ray(renderer, method, pixel);
    verdict_.reset();
    fresh_ = !was_open;
    at_left_ = 2 * pixel.x > renderer.width();
    reference.ask(report_->ray);
}

void RayPanel::draw_heading(const Scene& scene) {
    ImGui::PushTextWrapPos(0);
    for (const std::string& line : summary(*report_, scene)) ImGui::TextUnformatted(line.c_str());
    ImGui::PushStyleColor(ImGuiCol_Text, verdict_ ? kAccent : kTextDim);
    if (verdict_) {
        for (const std::string& line : describe(*report_, *verdict_, scene))
            ImGui::TextUnformatted(line.c_str());
    } else {
        ImGui::TextUnformatted("reference: on its way");
    }
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    if (push_button("Copy", true, "All of it as text, to the clipboard."))
        ImGui::SetClipboardText(full_text(*report_, verdict_, scene).c_str());
}

void RayPanel::draw_visits(const Scene& scene) {
    for (std::size_t i = 0; i < report_->visits.size(); ++i) {
        const RayReport::Visit& visit = report_->visits[i];
        const bool decisive = report_->hit_visit == i;
        ImGui::PushID(static_cast<int>(i));
        ImGui::SetNextItemOpen(decisive || report_->visits.size() == 1, ImGuiCond_Once);
        const std::string line = std::to_string(i + 1) + ".  " + describe(visit, scene);
        const ImU32 colour = decisive ? kGood : visit.notes.empty() ? kTextDim : kText;
        ImGui::PushStyleColor(ImGuiCol_Text, colour);
        const bool open = ImGui::TreeNodeEx(line.c_str(), visit.notes.empty() ? ImGuiTreeNodeFlags_Leaf : 0);
        ImGui::PopStyleColor();
        if (open) {
            if (!visit.notes.empty()) draw_notes(visit.notes);
            ImGui::TreePop();
        }
        ImGui::PopID();
    }
}

void RayPanel::draw(const Session& session, LiveReference& reference, const Box& picture) {
    if (!report_) return;
    if (auto verdict = reference.take_verdict()) verdict_ = verdict;
    const bool moved = picture.width != placed_in_.width || picture.height != placed_in_.height;
    placed_in_ = picture;
    const float margin = points(14);
    const float most_width = std::max(points(200), static_cast<float>(picture.width) - 2 * margin);
    const float most_height = std::max(points(120), static_cast<float>(picture.height) - points(110));
    const float share = 0.6f * static_cast<float>(picture.width);
    const float width = std::min(std::clamp(share, points(300), points(536)), most_width);
    // Not over the pixel that was asked about, where there is room beside it.
    const float right = static_cast<float>(picture.x + picture.width) - margin - width;
    const ImVec2 corner(at_left_ ? static_cast<float>(picture.x) + margin : right,
                        static_cast<float>(picture.y) + points(44));
    const auto when = fresh_ || moved ? ImGuiCond_Always : ImGuiCond_Appearing;
    ImGui::SetNextWindowPos(corner, when);
    ImGui::SetNextWindowSize({width, std::min(points(430), most_height)}, when);
    ImGui::SetNextWindowSizeConstraints({std::min(points(300), most_width), points(120)},
                                        {most_width, most_height});
    fresh_ = false;
    bool open = true;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, points(5));
    const bool visible = ImGui::Begin("Why this pixel", &open,
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse |
                                          ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PopStyleVar();
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    box_ = {static_cast<int>(at.x), static_cast<int>(at.y), static_cast<int>(size.x),
            static_cast<int>(size.y)};
    if (visible) {
        draw_heading(session.scene());
        ImGui::Separator();
        ImGui::BeginChild("visits", ImVec2(0, 0), false,
                          ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoNav);
        draw_visits(session.scene());
        ImGui::EndChild();
    }
    ImGui::End();
    if (!open) close();
}

void RayPanel::draw_mark(ImDrawList& list, const Session& session, const Box& picture) const {
    if (!report_ || !report_->hit) return;
    const Scene& scene = session.scene();
    const glm::vec3 point =
        report_->ray.origin + report_->ray.direction * static_cast<float>(report_->distance);
    const auto px = project(scene.camera, scene.origin, picture.width, picture.height, point);
    if (!px || px->x < 0 || px->y < 0 || px->x > picture.width || px->y > picture.height) return;
    const ImVec2 at(static_cast<float>(picture.x + px->x), static_cast<float>(picture.y + px->y));
    list.AddCircle(at, points(8), kRingShadow, 24, points(3));
    list.AddCircle(at, points(8), kAccent, 24, points(1.5f));
    list.AddCircleFilled(at, points(1.5f), kAccent);
}

}  // namespace relievo::gui
