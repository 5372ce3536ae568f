// Short messages over the picture: what went wrong, what was saved.
#pragma once

#include <chrono>
#include <deque>
#include <string>

namespace relievo::gui {

class Toasts {
  public:
    void info(const std::string& text) { add(text, false); }
    void error(const std::string& text) { add(text, true); }

    // Stacked upwards from (x, y), the lower left corner, at most `width` wide (pixels).
    void draw(float x, float y, float width);
    bool empty() const { return toasts_.empty(); }

  private:
    using Clock = std::chrono::steady_clock;
    struct Toast {
        std::string text;
        bool is_error;
        Clock::time_point until;
    };
    void add(const std::string& text, bool is_error);

    std::deque<Toast> toasts_;  // oldest first
};

}  // namespace relievo::gui
