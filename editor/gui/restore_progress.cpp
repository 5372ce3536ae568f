// See restore_progress.h.
#include "editor/gui/restore_progress.h"

#include <imgui.h>

#include <stdexcept>
#include <string>

#include "editor/gui/theme.h"
#include "editor/gui/widgets.h"

namespace relievo::gui {
namespace {

constexpr const char* kTitle = "Restoring";
constexpr auto kBetweenFrames = std::chrono::milliseconds(100);

}  // namespace

void RestoreProgress::show(std::size_t done, std::size_t total) {
    if (Clock::now() < next_ || total == 0) return;
    if (!screen_) screen_.emplace(*context_, *window_);
    window_->poll();
    window_->events().clear();
    bool stopped = window_->close_wanted();
    if (screen_->begin()) {
        if (!ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
        if (begin_modal(kTitle, 460)) {
            const std::string text = std::to_string(done) + " of " + std::to_string(total) + " edits";
            ImGui::ProgressBar(static_cast<float>(done) / static_cast<float>(total), ImVec2(-1, 0), text.c_str());
            ImGui::TextDisabled("Esc stops; the next start offers them again.");
            stopped = stopped || escape_pressed();
            ImGui::EndPopup();
        }
        screen_->end({}, 0, 0);
    }
    if (stopped) throw std::runtime_error("Restoring was stopped; the next start offers the edits again");
    next_ = Clock::now() + kBetweenFrames;
}

}  // namespace relievo::gui
