// See frame_log.h.
#include "editor/gui/frame_log.h"

#include <chrono>
#include <stdexcept>

#include "editor/session/text.h"

namespace relievo::gui {
namespace {

double now_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace

FrameLog::FrameLog(const std::filesystem::path& path) {
    if (path.empty()) return;
    file_.open(path);
    if (!file_) throw std::invalid_argument("--frame-log: cannot write " + path.string());
}

void FrameLog::sculpted(const InputEvent& event, std::uint64_t window_start_us) {
    if (!file_.is_open()) return;
    pending_.push_back({event.x, event.y, static_cast<double>(window_start_us + event.time_us) / 1000});
}

void FrameLog::traced(const PixelRect& r) {
    for (Dab& dab : pending_)
        dab.traced = dab.traced || (dab.x >= r.x0 && dab.y >= r.y0 && dab.x < r.x1 && dab.y < r.y1);
}

void FrameLog::shown(bool in_stroke, const TurnTimes& t, std::size_t undo_bytes) {
    if (!file_.is_open()) return;
    const double at = now_ms();
    file_ << formatted(
        "{\"frame\": {\"at_ms\": %.2f, \"in_stroke\": %s, \"input_ms\": %.2f, \"trace_ms\": %.2f, "
        "\"cursor_ms\": %.2f, \"draw_ms\": %.2f, \"undo_bytes\": %zu}}\n",
        at, in_stroke ? "true" : "false", t.input_ms, t.trace_ms, t.cursor_ms, t.draw_ms, undo_bytes);
    for (const Dab& dab : pending_)
        if (dab.traced)
            file_ << formatted("{\"dab\": {\"x\": %.1f, \"y\": %.1f, \"event_ms\": %.2f, \"at_ms\": %.2f}}\n",
                               dab.x, dab.y, dab.event_ms, at);
    std::erase_if(pending_, [](const Dab& dab) { return dab.traced; });
    file_.flush();
}

}  // namespace relievo::gui
