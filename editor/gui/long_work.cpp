// See long_work.h.
#include "editor/gui/long_work.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cstddef>

#include "editor/gui/widgets.h"

namespace relievo::gui {

bool poll_behind_work(Window& window, std::size_t kept) {
    using Kind = InputEvent::Kind;
    auto& events = window.events();
    const auto place = [&](std::size_t index) { return events.begin() + static_cast<std::ptrdiff_t>(index); };
    const std::size_t before = events.size();
    window.poll();
    const bool may_stop = std::any_of(place(before), events.end(), [](const InputEvent& event) {
        return event.kind != Kind::move && event.kind != Kind::scroll;
    });
    const auto is_for_work = [](const InputEvent& event) {
        const bool key = event.kind == Kind::key && event.code != GLFW_KEY_ESCAPE && !event.repeated;
        return !key && event.kind != Kind::release;
    };
    events.erase(std::remove_if(place(kept), events.end(), is_for_work), events.end());
    return may_stop;
}

void draw_long_work(std::optional<WorkShown>& work) {
    constexpr const char* kTitle = "Working";
    if (work && !ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
    // Nothing is left of it in the frame that closes it.
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, work ? 1.0f : 0.01f);
    const bool open = begin_modal(kTitle, 460);
    ImGui::PopStyleVar();
    if (!open) return;
    if (work) {
        path_text(work->title);
        // A driver may still compile what was made, at its first use.
        const char* const text = !work->text.empty() ? work->text.c_str() : work->part >= 1 ? "Nearly done" : nullptr;
        ImGui::ProgressBar(static_cast<float>(work->part), ImVec2(-1, 0), text);
        ImGui::Spacing();
        if (dialog_button("Stop") || escape_pressed()) work->stopped = true;
    } else {
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace relievo::gui
