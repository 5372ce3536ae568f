// From pointer events on the picture to a stroke of the session.
#include "editor/gui/stroke_control.h"

#include <GLFW/glfw3.h>

#include <stdexcept>
#include <string>

#include "brushes/dab_cost.h"

namespace relievo::gui {
namespace {

// Texels that draw would visit at every dab: about a second on two cores, in which the window stands still.
// Memory follows: at most 150 MB of a map of a million texels.
constexpr double kMostWork = 8e6;

// A stroke that starts beside the object is judged by the first face.
void refuse_heavy(const Session& session, const Brush& brush, const PickHit& hit) {
    const Surface& surface = session.surface();
    if (surface.face_count() == 0) return;
    constexpr float kThird = 1.0f / 3.0f;
    const bool on_it = hit.hit && hit.object == 0;
    const SurfacePoint centre = on_it ? surface.at(hit.face, hit.b1, hit.b2) : surface.at(0, kThird, kThird);
    const DabCost cost = dab_cost(brush, centre, surface);
    if (!(cost.work > kMostWork)) return;
    const std::string texels = std::to_string(cost.texels / 1000) + " thousand texels";
    throw std::invalid_argument("Every dab would take long: the brush reaches " + texels +
                                (cost.copies > 1 ? " in each of " + std::to_string(cost.copies) +
                                                       " copies. Make it smaller, or use fewer copies"
                                                 : ". Make it smaller"));
}

}  // namespace

PointerEvent StrokeControl::pointer(const InputEvent& event) const {
    return {event.time_us, live_->to_renderer_x(event.x), live_->to_renderer_y(event.y),
            event.touch.pressure};
}

Brush StrokeControl::brush_for(const InputEvent& event) const {
    Brush brush = session_->brush();
    if (event.mods & GLFW_MOD_SHIFT) {
        if (brush.tool == Tool::mask)
            brush.blur = true;
        else
            brush.tool = Tool::smooth;
    }
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
    const PointerEvent at = pointer(event);
    const Ray ray = session.renderer().camera_ray(at.x_px, at.y_px);
    const PickHit hit = session.renderer().pick(std::span(&ray, 1)).front();
    if (settings.unit != RadiusUnit::world)
        brush.radius = session.world_radius(hit, ray, session.renderer().camera_ray(at.x_px + 1, at.y_px));
    refuse_heavy(session, brush, hit);
    session.brush() = brush;
    try {
        session.begin_stroke();
    } catch (...) {
        session.brush() = chosen;
        throw;
    }
    session.brush() = chosen;
    live.begin_stroke(brush.tool == Tool::mask);
    input_.emplace(
        brush, [&session](std::span<const Ray> rays) { return session.renderer().pick(rays); },
        [&session](double x, double y) { return session.renderer().camera_ray(x, y); },
        [this, &session, &live](const Dab& dab) {
            session.dab(dab);
            ++dabs_;
            live.after_dab();
        },
        settings, [this] { return std::chrono::steady_clock::now() < allowed_until_; });
    input_->begin(at);
}

void StrokeControl::move(const InputEvent& event) {
    if (input_) input_->move(pointer(event));
}

void StrokeControl::rest(std::uint64_t time_us) {
    if (input_) input_->rest(time_us);
}

void StrokeControl::end(const InputEvent& event) {
    if (!input_) return;
    ending_ = true;
    input_->end(pointer(event));
    finish();
}

void StrokeControl::work() {
    if (!busy()) return;
    input_->work();
    finish();
}

void StrokeControl::finish() {
    if (!ending_ || busy()) return;
    ending_ = false;
    input_.reset();
    const bool changed = session_->last_dab().has_value();
    session_->end_stroke();
    live_->end_stroke(changed);
}

void StrokeControl::cancel() {
    if (!input_) return;
    ending_ = false;
    input_.reset();
    const bool changed = session_->last_dab().has_value();
    session_->cancel_stroke();
    live_->cancel_stroke(changed);
}

}  // namespace relievo::gui
