// See wait_screen.h.
#include "editor/gui/wait_screen.h"

#include <GLFW/glfw3.h>
#include <deque>

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
    shown_->part = part;
    shown_->text = text;
    if (screen_->begin()) {
        draw_long_work(shown_);
        screen_->end({}, 0, 0);
    }
    next_ = Clock::now() + kBetweenFrames;
    return !shown_->stopped && !window_->close_wanted();
}

}  // namespace relievo::gui
