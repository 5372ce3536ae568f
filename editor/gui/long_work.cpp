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
    if (!begin_modal(kTitle, 460)) return;
    if (work) {
        path_text(work->title);
        ImGui::ProgressBar(static_cast<float>(work->part), ImVec2(-1, 0), work->text.empty() ? nullptr : work->text.c_str());
        ImGui::Spacing();
        if (dialog_button("Stop") || escape_pressed()) work->stopped = true;
    } else {
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace relievo::gui
