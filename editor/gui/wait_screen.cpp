// See wait_screen.h.
#include "editor/gui/wait_screen.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <deque>

#include "editor/gui/widgets.h"

namespace relievo::gui {

bool WaitScreen::show(double part, const std::string& text) {
    constexpr auto kBetweenFrames = std::chrono::milliseconds(100);
    if (Clock::now() < next_) return true;
    if (!context_) context_ = &own_.emplace(options_);
    if (!screen_) screen_.emplace(*context_, *window_);
    window_->poll();
    // Keys that are struck meanwhile are for what comes.
    std::erase_if(window_->events(), [](const InputEvent& event) {
        return event.kind != InputEvent::Kind::key || event.code == GLFW_KEY_ESCAPE;
    });
    bool stopped = window_->close_wanted();
    if (screen_->begin()) {
        const char* const title = words_.title.c_str();
        if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
        if (begin_modal(title, 460)) {
            ImGui::ProgressBar(static_cast<float>(part), ImVec2(-1, 0), text.empty() ? nullptr : text.c_str());
            ImGui::TextDisabled("%s", words_.hint.c_str());
            stopped = stopped || escape_pressed();
            ImGui::EndPopup();
        }
        screen_->end({}, 0, 0);
    }
    next_ = Clock::now() + kBetweenFrames;
    return !stopped;
}

}  // namespace relievo::gui
