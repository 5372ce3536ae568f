// From pointer events on the picture to a stroke of the session.
#pragma once

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
    std::uint64_t dabs() const { return dabs_; }  // made so far, in all strokes

    // The brush that a press takes: the session's, turned round by Ctrl and by a pen's eraser, smoothing with
    // Shift.
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

    Session* session_;
    LivePicture* live_;
    std::optional<StrokeInput> input_;
    std::uint32_t strokes_ = 0;  // so far: the seed of the next one's jitter
    std::uint64_t dabs_ = 0;
};

}  // namespace relievo::gui
