// What a person would feel, in numbers: when each frame was shown, and how long after its pointer event each
// dab was to be seen. For tests and for reports of slowness; written only where it is asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

#include "editor/gui/window.h"
#include "renderer/renderer.h"

namespace relievo::gui {

// Milliseconds of one turn of the window's loop.
struct TurnTimes {
    double input_ms = 0, trace_ms = 0, cursor_ms = 0, draw_ms = 0;
};

// JSON Lines. Times `at_ms` are the steady clock's, so that another process on the machine can compare them
// with its own:
//   {"frame": {"at_ms", "in_stroke", "input_ms", "trace_ms", "cursor_ms", "draw_ms", "undo_bytes"}}  a frame
//       was handed to the display, when undo steps held so much;
//   {"dab": {"x", "y", "event_ms", "at_ms"}}  the surface as a pointer event at (x, y), window pixels, left
//   it
//       is in the frame of `at_ms`; `event_ms`: when the window heard of the event.
class FrameLog {
  public:
    // An empty path: nothing is written. Throws std::invalid_argument when the file cannot be made.
    explicit FrameLog(const std::filesystem::path& path);

    void sculpted(const InputEvent& event, std::uint64_t window_start_us);  // it made a dab at least
    void cancelled() { pending_.clear(); }
    void traced(const PixelRect& window);  // window pixels: what was sculpted in it is in the next frame
    void shown(bool in_stroke, const TurnTimes& times, std::size_t undo_bytes);

  private:
    struct Dab {
        double x, y, event_ms;
        bool traced = false;
    };
    std::ofstream file_;
    std::vector<Dab> pending_;  // not shown yet, oldest first
};

}  // namespace relievo::gui
