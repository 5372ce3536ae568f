// From pointer events on the picture to a stroke of the session.
#include "editor/gui/stroke_control.h"

#include <GLFW/glfw3.h>

namespace relievo::gui {

PointerEvent StrokeControl::pointer(const InputEvent& event) const {
    return {event.time_us, live_->to_renderer_x(event.x), live_->to_renderer_y(event.y), event.touch.pressure};
}

Brush StrokeControl::brush_for(const InputEvent& event) const {
    Brush brush = session_->brush();
    if (event.mods & GLFW_MOD_SHIFT) brush.tool = Tool::smooth;
    if (event.mods & GLFW_MOD_CONTROL) brush.invert = !brush.invert;
    if (event.touch.eraser) brush.invert = !brush.invert;
    return brush;
}

void StrokeControl::begin(const InputEvent& event) {
    const Brush chosen = session_->brush();
    Brush brush = brush_for(event);
    Session& session = *session_;
    LivePicture& live = *live_;
    StrokeSettings settings = session.stroke_settings();
    settings.seed = ++strokes_;
    check_stroke_settings(settings);
    if (settings.unit != RadiusUnit::world) {
        const PointerEvent at = pointer(event);
        const Ray ray = session.renderer().camera_ray(at.x_px, at.y_px);
        const Ray beside = session.renderer().camera_ray(at.x_px + 1, at.y_px);
        brush.radius = session.world_radius(session.renderer().pick(std::span(&ray, 1)).front(), ray, beside);
    }
    session.brush() = brush;
    try {
        session.begin_stroke();
    } catch (...) {
        session.brush() = chosen;
        throw;
    }
    session.brush() = chosen;
    live.begin_stroke();
    input_.emplace(
        brush, [&session](std::span<const Ray> rays) { return session.renderer().pick(rays); },
        [&session](double x, double y) { return session.renderer().camera_ray(x, y); },
        [this, &session, &live](const Dab& dab) {
            session.dab(dab);
            ++dabs_;
            live.after_dab();
        },
        settings);
    input_->begin(pointer(event));
}

void StrokeControl::move(const InputEvent& event) {
    if (input_) input_->move(pointer(event));
}

void StrokeControl::rest(std::uint64_t time_us) {
    if (input_) input_->rest(time_us);
}

void StrokeControl::end(const InputEvent& event) {
    if (!input_) return;
    input_->end(pointer(event));
    input_.reset();
    const bool changed = session_->last_dab().has_value();
    session_->end_stroke();
    live_->end_stroke(changed);
}

void StrokeControl::cancel() {
    if (!input_) return;
    input_.reset();
    const bool changed = session_->last_dab().has_value();
    session_->cancel_stroke();
    live_->end_stroke(changed);
    if (changed) live_->restart();
}

}  // namespace relievo::gui
