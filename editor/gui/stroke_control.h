// From pointer events on the picture to a stroke of the session.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "editor/gui/live_picture.h"
#include "editor/gui/window.h"
#include "editor/session/stroke_input.h"

namespace relievo::gui {

class StrokeControl {
  public:
    StrokeControl(Session& session, LivePicture& live) : session_(&session), live_(&live) {}

    bool active() const { return input_.has_value(); }
    // Dabs of the last event are left to make, and the next event must wait for them; also behind end().
    bool busy() const { return input_ && input_->busy(); }
    bool ending() const { return ending_; }
    // Dabs begun later are left over, all but one a call.
    void allow_until(std::chrono::steady_clock::time_point time) { allowed_until_ = time; }
    void work();  // goes on with what was left over
    std::uint64_t dabs() const { return dabs_; }  // made so far, in all strokes

    // The brush that a press takes: the session's, turned round by Ctrl and by a pen's eraser, smoothing with
    // Shift what its tool changes: the mask, or else the surface.
    Brush brush_for(const InputEvent& event) const;
    // Positions are in pixels of the picture on screen. Throws std::invalid_argument when a brush setting is
    // out of its range.
    void begin(const InputEvent& event);
    void move(const InputEvent& event);
    void rest(std::uint64_t time_us);  // no event came until then
    void end(const InputEvent& event);
    void cancel();

  private:
    PointerEvent pointer(const InputEvent& event) const;
    void finish();

    Session* session_;
    LivePicture* live_;
    std::optional<StrokeInput> input_;
    bool ending_ = false;  // released, but not all dabs are made
    std::chrono::steady_clock::time_point allowed_until_ = std::chrono::steady_clock::time_point::max();
    std::uint32_t strokes_ = 0;  // so far: the seed of the next one's jitter
    std::uint64_t dabs_ = 0;
};

}  // namespace relievo::gui
