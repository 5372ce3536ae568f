// What is traced next, in slices short enough for the interface to stay responsive:
// - while a stroke runs, the window of 256 x 256 pixels around the brush, then whatever else it left stale;
// - while the camera or a slider moves, the whole picture at a size that keeps up;
// - else the stale parts in preview quality, and then one sample a pixel after another up to a bound.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "editor/gui/picture.h"
#include "editor/session/session.h"

namespace relievo::gui {

class LivePicture {
  public:
    LivePicture(Session& session, VkFormat format);  // format: the screen's

    const Picture& picture() const { return picture_; }
    PixelSize size() const { return picture_.size(); }

    // Pixels on screen; at most one of every `reduction` pixels each way is traced.
    void resize(PixelSize size);
    void set_reduction(int reduction);
    int reduction() const { return reduction_; }

    // From pixels on screen, relative to the picture's corner, to those of the renderer's present image.
    double to_renderer_x(double x) const;
    double to_renderer_y(double y) const;

    void in_motion();               // camera or settings change continuously: show something now
    void restart();                 // all is stale, keep what is shown until it is replaced
    void begin_stroke();            // full size from now on
    void after_dab();               // session.last_dab() changed the surface
    void end_stroke(bool changed);  // false: it left the surface as it was

    // Traces what is most wanted, at least one slice, then more until `budget_ms` have passed.
    void work(double budget_ms);
    bool idle() const;  // nothing is left to trace

    bool take_changed();  // something new is to be seen since the last call

    int samples() const;
    double progress() const;  // of the preview and the first sample together, [0, 1]
    int sample_limit() const { return sample_limit_; }
    void set_sample_limit(int limit);
    double trace_ms() const {
        return trace_ms_;
    }  // of the last whole-image pass, live window or moving frame

  private:
    enum class Phase { moving, stale, sampling };
    using Clock = std::chrono::steady_clock;

    Renderer& renderer() { return session_->renderer(); }
    PixelSize full_size() const;
    void set_renderer_size(PixelSize size);
    void mark_all_stale();
    void mark_stale(const glm::dvec2& centre_px, double radius_px);
    void clear_stale(const PixelRect& traced);
    void trace_moving();
    void trace_live();
    void trace_stale();
    void trace_sample();
    void start_sampling();
    void show(const PixelRect& window);
    PixelRect slice_from(int row, double ms_per_pixel) const;
    PixelRect next_stale() const;

    Session* session_;
    Picture picture_;
    Phase phase_ = Phase::moving;
    Clock::time_point last_motion_{}, sampling_since_{};
    int reduction_ = 1, sample_limit_ = 256;
    double preview_ms_ = 1e-3, sample_ms_ = 3e-3;  // a pixel, as last measured
    double trace_ms_ = 0, pass_ms_ = 0;
    int next_row_ = 0;  // of the sample under way
    bool in_stroke_ = false, live_due_ = false, changed_ = false;
    std::vector<std::uint8_t> stale_;  // tiles of kTile x kTile pixels, row by row
    int tiles_x_ = 0, tiles_y_ = 0, stale_count_ = 0;
};

}  // namespace relievo::gui
