// Colours, spacing and fonts of the interface.
#pragma once

#include <imgui.h>

namespace relievo::gui {

constexpr ImU32 kAccent = IM_COL32(238, 146, 74, 255);
constexpr ImU32 kAccentDim = IM_COL32(238, 146, 74, 90);
constexpr ImU32 kBar = IM_COL32(150, 98, 58, 255);
constexpr ImU32 kBarHot = IM_COL32(174, 112, 64, 255);
constexpr ImU32 kRing = IM_COL32(245, 246, 248, 235);
constexpr ImU32 kRingShadow = IM_COL32(0, 0, 0, 130);
constexpr ImU32 kText = IM_COL32(222, 224, 228, 255);
constexpr ImU32 kTextDim = IM_COL32(146, 151, 160, 255);
constexpr ImU32 kWarning = IM_COL32(240, 184, 82, 255);
constexpr ImU32 kError = IM_COL32(235, 98, 84, 255);
constexpr ImU32 kGood = IM_COL32(120, 190, 120, 255);
constexpr ImU32 kPanel = IM_COL32(37, 39, 44, 255);
constexpr ImU32 kLine = IM_COL32(22, 23, 26, 255);

// Sets style and fonts of the current Dear ImGui context; `scale` is the display's.
void apply_theme(double scale);

// Points to pixels of this display.
float points(float value);

ImFont* strong_font();  // for headings; the ordinary font where the system has no bold one

}  // namespace relievo::gui
