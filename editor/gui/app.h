// One open scene in the window: the loop of input, tracing and drawing.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

#include "editor/gui/desk.h"
#include "editor/gui/dialogs.h"
#include "editor/gui/frame_log.h"
#include "editor/gui/layout.h"
#include "editor/gui/pointer_control.h"
#include "editor/gui/screen.h"
#include "editor/gui/screenshots.h"

namespace relievo::gui {

class App {
  public:
    // `most_fps`: frames a second, 0: no limit. `message`: shown at the start, as an error; may be empty.
    App(Window& window, Screen& screen, Session& session, FrameLog& log, double most_fps,
        const std::string& message);

    void offer(std::vector<AbandonedJournal> abandoned);
    // Until the user leaves the scene.
    Departure run();

  private:
    void wait_for_input();
    void draw();
    void note_traced();
    void give_memory_back();
    void end_hint();
    void skip_to_escape();
    void take_dropped();
    void handle_input();
    void handle_key(const InputEvent& event);
    bool picture_free() const;
    bool picture_free_at(double x, double y) const;
    void draw_over_picture();
    void follow_pointer();
    void draw_interface();
    void update_title();
    void tell_screenshots();
    void tell_step_not_held();
    void do_work();

    Window* window_;
    Screen* screen_;
    FrameLog* log_;
    double least_frame_ms_;  // from one frame to the next
    TurnTimes times_;
    Toasts toasts_;
    Screenshots screenshots_;
    LiveReference reference_;
    LivePicture live_;
    Desk desk_;
    PointerControl pointer_;
    Dialogs dialogs_;
    Layout layout_;
    std::string journal_trouble_;  // as last shown
    std::uint64_t steps_seen_;     // the session's steps_made()
    std::uint64_t programs_seen_ = 0;  // compiled when memory was last given back
    std::chrono::steady_clock::time_point memory_given_{};
    double x_ = -1, y_ = -1;       // of the pointer, window pixels
    int closing_frames_ =
        0;  // after a dialog closed: what Dear ImGui says about typing is still the dialog's
    bool pointer_stale_ = false;  // the surface under the pointer may have changed
    std::chrono::steady_clock::time_point last_drawn_{};
    int frames_due_ = 3;  // drawn before the loop rests: the interface settles over a few frames
};

}  // namespace relievo::gui
