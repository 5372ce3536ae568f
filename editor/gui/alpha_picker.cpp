// The stamp's images in the side panel. Dear ImGui's Vulkan backend cannot show pictures of ours: a thumbnail
// is a grid of rectangles whose corners have the image's values.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "editor/gui/panels.h"
#include "editor/gui/theme.h"
#include "editor/gui/widgets.h"

namespace relievo::gui {
namespace {

void draw_thumbnail(ImDrawList& list, const AlphaShelf::Entry& entry, ImVec2 low, float size) {
    constexpr int kCells = AlphaShelf::kThumbnail;
    const auto shade = [&](int x, int y) {
        const float value = entry.thumbnail[static_cast<std::size_t>(y * (kCells + 1) + x)];
        const int grey = 22 + static_cast<int>(std::lround(200 * std::sqrt(std::min(value, 1.0f))));
        return IM_COL32(grey, grey, grey, 255);
    };
    const auto edge = [&](float from, int i) { return from + size * static_cast<float>(i) / kCells; };
    for (int y = 0; y < kCells; ++y)
        for (int x = 0; x < kCells; ++x)
            list.AddRectFilledMultiColor({edge(low.x, x), edge(low.y, kCells - 1 - y)},
                                         {edge(low.x, x + 1), edge(low.y, kCells - y)}, shade(x, y + 1),
                                         shade(x + 1, y + 1), shade(x + 1, y), shade(x, y));
}

bool thumbnail_button(const AlphaShelf::Entry& entry, float size, bool chosen) {
    ImGui::PushID(entry.alpha.get());
    const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + size, low.y + size);
    const bool pushed = ImGui::InvisibleButton("alpha", ImVec2(size, size));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_thumbnail(list, entry, low, size);
    if (chosen)
        list.AddRect(low, high, kAccent, 0, 0, points(2));
    else if (ImGui::IsItemHovered())
        list.AddRect(low, high, kText, 0, 0, points(1));
    tooltip(entry.alpha->path().string() + "\n" + std::to_string(entry.alpha->width()) + " x " +
                std::to_string(entry.alpha->height()) + " pixels",
            entry.name);
    ImGui::PopID();
    return pushed;
}

}  // namespace

void draw_alpha_picker(Desk& desk) {
    row_label("Image");
    const float left = ImGui::GetCursorPosX(), gap = points(4);
    const float room = ImGui::GetContentRegionAvail().x;
    const int columns = std::max(1, static_cast<int>((room + gap) / (points(40) + gap)));
    const float size = (room - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    int column = 0;
    for (const AlphaShelf::Entry& entry : desk.alphas.entries()) {
        if (column > 0) ImGui::SameLine(0, gap);
        if (column == 0) ImGui::SetCursorPosX(left);
        if (thumbnail_button(entry, size, entry.alpha == desk.session.alpha()))
            desk.session.set_alpha(entry.alpha);
        column = (column + 1) % columns;
    }
    ImGui::SetCursorPosX(left);
    if (push_button("Open...", true,
                    "Any image: white is raised, black stays as it is. Where values go beyond 1, as those of EXR may, the "
                    "largest counts as white. Journals name the file and know its "
                    "values: keep it where it is."))
        desk.view.wanted = Dialog::alpha;
}

}  // namespace relievo::gui
