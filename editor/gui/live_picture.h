// The picture of the session in the window: one pane, or two side by side that compare methods, in one view.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "brushes/advance.h"
#include "editor/gui/live_pane.h"
#include "editor/session/live_reference.h"
#include "editor/session/render_output.h"

namespace relievo::gui {

class LivePicture {
  public:
    // `reference` outlives the picture. `format`: the screen's.
    LivePicture(Session& session, LiveReference& reference, VkFormat format);

    PixelSize size() const { return panes_.front()->picture().size(); }
    std::vector<PictureStrip> strips() const;

    // Pixels on screen; at most one of every `reduction` pixels each way is traced.
    void resize(PixelSize size);
    void set_reduction(int reduction);
    int reduction() const { return choice_.reduction; }
    void set_sample_limit(int limit) { choice_.sample_limit = limit; }
    int sample_limit() const { return choice_.sample_limit; }

    View view() const { return choice_.palette.view; }
    // Compiles what it needs; stopped, it leaves the view as it was.
    void set_view(View view, const Advance& advance = {});
    RayCount count() const { return choice_.count; }
    void set_count(RayCount count);  // of the view `steps`
    const ColourScale& scale() const { return choice_.palette.scale; }

    // Of the mask, where there is one and light is shown.
    void set_mask_shown(bool shown);
    bool mask_shown() const { return mask_shown_; }
    bool view_shows_mask() const { return !shows_layers(view()); }

    // The right part of the picture is traced by `method`; std::nullopt: one pane. Throws as Renderer does.
    void compare_with(const std::optional<MethodChoice>& method, const Advance& advance = {});
    bool is_split() const { return panes_.size() > 1; }
    double divider() const { return divider_; }  // share of the width that the left pane has
    void set_divider(double share);
    int divider_px() const;
    Renderer& renderer_at(double x);  // x: pixels on screen
    std::vector<RenderPart> parts();   // what is seen, in the renderers' pixels
    // Of a view that shows layers, what is seen; the panes must have one size.
    DisplayPicture layers() const;
    // Traces until every pixel is as the surface is now and both panes have their full size, as after a motion.
    void come_to_rest(const Advance& advance);

    // From pixels on screen, relative to the picture's corner, to those of the session's renderer.
    double to_renderer_x(double x) const;
    double to_renderer_y(double y) const;

    void in_motion();  // the rest as in live_pane.h
    void restart();
    void begin_stroke(bool of_mask);
    void after_dab();
    void end_stroke(bool changed);
    void cancel_stroke(bool changed);

    // Traces what is most wanted, at least one slice a pane, then more until `budget_ms` have passed; and
    // shows what the reference has found.
    void work(double budget_ms);
    bool idle() const;
    bool take_changed();
    // What of a stroke's surface was traced since the last call, pixels on screen, the left pane's.
    std::vector<PixelRect> take_traced();

    int samples() const;      // of the pane that has least
    double progress() const;  // likewise
    double trace_ms() const { return panes_.front()->trace_ms(); }
    double pass_ms(std::size_t pane) const { return panes_[pane]->pass_ms(); }
    // Of the view `error`.
    double reference_progress() const { return reference_->progress(); }
    const ErrorSummary& errors(std::size_t pane) const { return errors_[pane]; }

  private:
    using Clock = std::chrono::steady_clock;
    int middle() const;  // where the split is, in the renderers' pixels
    void show_strips();
    void follow_mask();
    void follow_reference();
    void sum_up_errors(bool complete);
    bool all_covered() const;
    void update_scale();
    ColourScale wanted_scale() const;
    double most_displacement() const;
    void repaint(int row_begin, int row_end);

    Session* session_;
    LiveReference* reference_;
    VkFormat format_;
    ViewChoice choice_;
    std::vector<std::unique_ptr<LivePane>> panes_;  // one or two
    std::uint64_t mask_seen_ = 0;  // revision
    bool mask_shown_ = true;
    double divider_ = 0.5;
    bool scale_due_ = true, scale_is_first_ = true, errors_due_ = false;
    std::vector<ErrorSummary> errors_{2};
    Clock::time_point summed_up_{};
};

}  // namespace relievo::gui
