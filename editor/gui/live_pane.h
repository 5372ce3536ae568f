// One renderer's picture and what it traces next, in slices short enough for the interface to stay
// responsive:
// - while a stroke runs, what the dabs touched, the nearest to the brush first, then the rest of the window
// of
//   256 x 256 pixels around it, then whatever else is stale;
// - while the camera or a slider moves, the whole picture at a size that keeps up;
// - else the stale parts (in preview quality where light is shown), and then, for light, one sample a pixel
// after
//   another up to a bound.
#pragma once

#include <chrono>
#include <cstdint>
#include <utility>
#include <vector>

#include "editor/gui/layer_image.h"
#include "editor/gui/mask_veil.h"
#include "editor/gui/picture.h"
#include "editor/gui/stale_tiles.h"
#include "editor/session/session.h"

namespace relievo::gui {

// What all panes show; LivePicture decides.
struct ViewChoice {
    RayCount count = RayCount::steps;
    int reduction = 1;       // at most one of so many pixels each way is traced
    int sample_limit = 256;  // a pixel
    Palette palette;
    bool veil = false;  // a mask is there, and to be shown over light
};

class LivePane {
  public:
    // All outlive the pane. `format`: the screen's.
    LivePane(Session& session, Renderer& renderer, VkFormat format, const ViewChoice& choice);

    Renderer& renderer() { return *renderer_; }
    const Renderer& renderer() const { return *renderer_; }
    const Picture& picture() const { return picture_; }
    PixelSize full_size() const;  // of the renderer's picture when nothing moves

    void resize(PixelSize size);        // pixels on screen
    void show_columns(int x0, int x1);  // the part that is on screen, pixels on screen
    void choose_view();                 // another view, count or method
    void in_motion();                   // camera or settings change continuously: show something now
    void restart();                     // all is stale, keep what is shown until it is replaced
    void begin_stroke(bool of_mask);    // full size from now on
    void after_dab();                   // session.last_dab() changed the surface, or the mask
    void end_stroke(bool changed);      // false: it left all as it was
    void cancel_stroke(bool changed);   // the session has cancelled it; false: likewise
    // The palette, or what it refers to, has changed; a window of the renderer's pixels.
    void repaint(const PixelRect& window);

    // The mask, or whether it is shown, has changed.
    void mask_changed();

    // Traces the most wanted piece, about `slice_ms` worth of it; in motion a whole frame of about
    // `moving_ms`, and then returns true.
    bool step(double slice_ms, double moving_ms);
    bool idle() const;     // nothing is left to trace
    bool covered() const;  // the whole picture at full size is traced as it is now, if only once
    bool take_changed();   // something new is to be seen since the last call
    // What of a stroke's surface was traced since the last call, pixels of the renderer.
    std::vector<PixelRect> take_traced() { return std::exchange(traced_, {}); }

    int samples() const;
    double progress() const;                       // of the preview and the first sample together, [0, 1]
    double trace_ms() const { return trace_ms_; }  // of the last whole pass, live window or moving frame
    double pass_ms() const;                        // median over the last whole passes of a kind; 0: none yet
    const LayerImage& layers() const { return layers_; }

  private:
    enum class Phase { moving, stale, sampling };
    using Clock = std::chrono::steady_clock;

    bool shows_layers() const { return gui::shows_layers(choice_->palette.view); }
    bool veiled() const { return choice_->veil && !shows_layers(); }
    // What lies under each pixel is known: another mask needs no ray.
    bool can_repaint() const {
        return veiled() && phase_ == Phase::sampling && veil_.knows_all() && veil_.size() == renderer_size();
    }
    void show_veiled(const PixelRect& window);
    void repaint_due();
    PixelSize renderer_size() const { return {renderer_->width(), renderer_->height()}; }
    PixelRect whole() const { return {0, 0, renderer_->width(), renderer_->height()}; }
    void set_renderer_size(PixelSize size);
    void mark_all_stale();
    void trace_moving(double moving_ms);
    void trace_stale(double slice_ms);
    void trace_sample(double slice_ms);
    double trace(const PixelRect& window);
    void start_sampling();
    void show(const PixelRect& window);
    void finish_pass();
    PixelRect on_screen() const;
    PixelRect slice_from(int row, double slice_ms) const;

    Session* session_;
    Renderer* renderer_;
    const ViewChoice* choice_;
    Picture picture_;
    LayerImage layers_;
    MaskVeil veil_;
    Phase phase_ = Phase::moving;
    Clock::time_point last_motion_{}, sampling_since_{};
    int shown_x0_ = 0, shown_x1_ = 1;
    double preview_ms_ = 1e-3, sample_ms_ = 3e-3;  // a pixel, as last measured
    double trace_ms_ = 0, pass_ms_ = 0, pass_pixels_ = 0;
    std::vector<double> passes_ms_;  // the last ones
    int next_row_ = 0;               // of the sample under way
    bool in_stroke_ = false, changed_ = false;
    bool repaints_ = false;  // in a stroke of the mask: the picture goes on under it
    PixelRect mask_due_{};   // what its dabs cover and is not shown yet
    StaleTiles stale_;
    glm::dvec2 focus_{0};  // pixels of the renderer: where the brush was last, else the middle
    double live_ms_ = 0;   // of tracing since the last dab
    std::vector<PixelRect> traced_;
};

}  // namespace relievo::gui
