// What the window shows while a long journal is replayed: how far it is, and that it can be stopped.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

#include "editor/gui/screen.h"
#include "editor/gui/window.h"

namespace relievo::gui {

class RestoreProgress {
  public:
    // Both outlive it. No other Screen may be there meanwhile.
    RestoreProgress(vulkan::Context& context, Window& window) : context_(&context), window_(&window) {}

    // Call it often. Throws std::runtime_error when the user presses Esc or closes the window.
    void show(std::size_t done, std::size_t total);

  private:
    using Clock = std::chrono::steady_clock;

    vulkan::Context* context_;
    Window* window_;
    Clock::time_point next_ = Clock::now() + std::chrono::milliseconds(500);  // a short replay shows nothing
    std::optional<Screen> screen_;
};

}  // namespace relievo::gui
