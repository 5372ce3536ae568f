// Short messages over the picture.
#include "editor/gui/toasts.h"

#include <imgui.h>

#include <algorithm>

#include "editor/gui/theme.h"

namespace relievo::gui {
namespace {

constexpr std::size_t kMost = 4;
constexpr std::chrono::seconds kInfoTime{4}, kErrorTime{12};

}  // namespace

void Toasts::add(const std::string& text, bool is_error) {
    // The same trouble again (a slider held at a refused value) is one message.
    std::erase_if(toasts_, [&](const Toast& toast) { return toast.text == text; });
    toasts_.push_back({text, is_error, Clock::now() + (is_error ? kErrorTime : kInfoTime)});
    if (toasts_.size() > kMost) toasts_.pop_front();
}

void Toasts::draw(float x, float y, float width) {
    std::erase_if(toasts_, [](const Toast& toast) { return toast.until < Clock::now(); });
    // A dialog lies over them: it says itself what is wrong with it.
    const bool dialog =
        ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    ImDrawList& list = dialog ? *ImGui::GetBackgroundDrawList() : *ImGui::GetForegroundDrawList();
    const float pad = points(10), bar = points(4);
    for (auto toast = toasts_.rbegin(); toast != toasts_.rend(); ++toast) {
        const float wrap = width - 2 * pad - bar;
        const ImVec2 text = ImGui::CalcTextSize(toast->text.c_str(), nullptr, false, wrap);
        const ImVec2 low(x, y - text.y - 2 * pad), high(x + text.x + 2 * pad + bar, y);
        list.AddRectFilled(low, high, IM_COL32(28, 30, 34, 240), points(4));
        list.AddRectFilled(low, {low.x + bar, high.y}, toast->is_error ? kError : kGood, points(4),
                           ImDrawFlags_RoundCornersLeft);
        list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + bar + pad, low.y + pad}, kText,
                     toast->text.c_str(), nullptr, wrap);
        y = low.y - points(6);
    }
}

}  // namespace relievo::gui
