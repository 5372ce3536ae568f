// What the window shows while a scene is opened or a long journal is replayed: how far that is, and that it can be stopped.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "editor/gui/long_work.h"
#include "editor/gui/screen.h"
#include "editor/gui/window.h"
#include "editor/gui/work_pace.h"
#include "renderer/vulkan/context.h"

namespace relievo::gui {

class WaitScreen {
  public:
    // No other Screen may be there meanwhile. `context` empty: one of its own, made when there is something to show.
    WaitScreen(Window& window, vulkan::Context* context, const vulkan::ContextOptions& options,
               const std::string& title)
        : window_(&window), context_(context), options_(options), shown_(WorkShown{title}) {}

    // Call it often, with the part that is done, [0, 1]. False when the user stops it or closes the window.
    bool show(double part, const std::string& text = {});

  private:
    using Clock = std::chrono::steady_clock;

    Window* window_;
    vulkan::Context* context_;
    vulkan::ContextOptions options_;
    std::optional<WorkShown> shown_;
    Clock::time_point start_ = Clock::now();
    double look_ms_ = kUnseenWorkMs;  // since the start: when the user is next looked at
    WorkPace pace_;
    std::optional<vulkan::Context> own_;
    std::optional<Screen> screen_;
};

}  // namespace relievo::gui
