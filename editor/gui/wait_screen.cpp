// See wait_screen.h.
#include "editor/gui/wait_screen.h"

namespace relievo::gui {

bool WaitScreen::show(double part, const std::string& text) {
    const auto now_ms = [this] { return std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); };
    const double look_ms = now_ms();
    if (look_ms < look_ms_) return true;
    look_ms_ = look_ms + kWorkLookMs;
    if (!context_) context_ = &own_.emplace(options_);
    if (!screen_) screen_.emplace(*context_, *window_);
    const bool may_stop = poll_behind_work(*window_, 0);
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
