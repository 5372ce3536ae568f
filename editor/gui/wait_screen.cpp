// See wait_screen.h.
#include "editor/gui/wait_screen.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <deque>

namespace relievo::gui {

bool WaitScreen::show(double part, const std::string& text) {
    constexpr double kLookMs = 50;
    const auto now_ms = [this] { return std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); };
    const double look_ms = now_ms();
    if (look_ms < look_ms_) return true;
    look_ms_ = look_ms + kLookMs;
    if (!context_) context_ = &own_.emplace(options_);
    if (!screen_) screen_.emplace(*context_, *window_);
    auto& events = window_->events();
    const auto before = static_cast<std::ptrdiff_t>(events.size());
    window_->poll();
    const bool may_stop = std::any_of(events.begin() + before, events.end(), may_stop_work);
    // Keys that are struck meanwhile are for what comes.
    std::erase_if(events, [](const InputEvent& event) {
        return event.kind != InputEvent::Kind::key || event.code == GLFW_KEY_ESCAPE;
    });
    if (!may_stop && !pace_.due(look_ms)) return !window_->close_wanted();
    shown_->part = part;
    shown_->text = text;
    if (screen_->begin()) {
        draw_long_work(shown_);
        screen_->end({}, 0, 0);
    }
    pace_.drawn(look_ms, now_ms());
    return !shown_->stopped && !window_->close_wanted();
}

}  // namespace relievo::gui
