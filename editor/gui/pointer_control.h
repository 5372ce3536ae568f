// What the pointer does over the picture: strokes, camera drags, brush drags, the divider, questions. It
// decides at the press, and keeps to it until the release.
#pragma once

#include <chrono>

#include "editor/gui/desk.h"
#include "editor/gui/layout.h"
#include "editor/gui/stroke_control.h"

namespace relievo::gui {

class PointerControl {
  public:
    explicit PointerControl(Desk& desk) : desk_(&desk), stroke_(desk.session, desk.live) {}

    // Events in their order, positions on the window. `picture_free`: no dialog or menu lies over the
    // picture.
    void on_event(const InputEvent& event, const Box& picture, bool picture_free);
    void cancel();  // Esc: the stroke, or the drag of camera or brush, leaves all as it was

    void keep_drag();  // of the brush or the light, that a key has started: it ends

    void rest(std::uint64_t time_us) { stroke_.rest(time_us); }  // no event came until then

    bool in_stroke() const { return stroke_.active(); }
    // Of the stroke (StrokeControl): while it is busy, events wait.
    bool busy() const { return stroke_.busy(); }
    bool stroke_ends() const { return stroke_.ending(); }
    void allow_until(std::chrono::steady_clock::time_point time) { stroke_.allow_until(time); }
    void work() { stroke_.work(); }
    std::uint64_t dabs() const { return stroke_.dabs(); }
    bool dragging() const { return stroke_.active() || divider_ || drag_ != CameraDrag::none; }
    bool drags_divider() const { return divider_; }
    // The movements of the camera since the last call, as one command, and of the light.
    void apply_moves();

  private:
    enum class CameraDrag { none, orbit, pan, zoom };
    void ask(const InputEvent& local);
    void tell_if_mask_is_unseen();
    void on_press(const InputEvent& local);
    void on_move(const InputEvent& local);
    void on_release(const InputEvent& local);
    void drag_camera(double dx, double dy);
    void drag_brush(double dx, double dy);
    Camera& moving_camera();
    void apply_camera();

    Desk* desk_;
    StrokeControl stroke_;
    CameraDrag drag_ = CameraDrag::none;
    int drag_button_ = 0;
    bool divider_ = false;                 // dragged
    std::optional<Camera> camera_before_;  // of a camera drag
    std::optional<Camera> camera_;         // moved, not yet given to the session
    struct Dragged {
        Brush brush;
        StrokeSettings settings;  // which hold the size where pixels or texels count it
    };
    std::optional<Dragged> brush_before_;  // of a brush drag
    struct Light {
        std::vector<relievo::Light> lights;
        glm::dvec3 sky_up;
    };
    std::optional<Light> light_before_;         // of a drag of the light
    double light_across_ = 0, light_down_ = 0;  // pixels, not yet given to the session
    double last_x_ = 0, last_y_ = 0;
    int picture_width_ = 1, picture_height_ = 1;
};

}  // namespace relievo::gui
