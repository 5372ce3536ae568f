// See long_work.h.
#include "editor/gui/long_work.h"

#include <imgui.h>

#include "editor/gui/widgets.h"

namespace relievo::gui {

bool may_stop_work(const InputEvent& event) {
    return event.kind != InputEvent::Kind::move && event.kind != InputEvent::Kind::scroll;
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
