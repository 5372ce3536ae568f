// One renderer's picture and what it traces next.
#include "editor/gui/live_pane.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "editor/session/replay.h"
#include "editor/session/view_window.h"
#include "renderer/stopwatch.h"

namespace relievo::gui {
namespace {

constexpr int kTile = StaleTiles::kTile;
constexpr double kStillAfterMs = 160;  // without a change, the motion is over
constexpr int kCoarsest = 8;
// The first samples are noisier than the preview that they replace: they are shown together.
constexpr int kFirstShown = 4;
constexpr double kShownAtLatestMs = 3000;
constexpr std::size_t kPassesKept = 9;
constexpr double kNotWhole = -1e18;  // pixels of a pass that has lost some of them

double pixels(const PixelRect& r) {
    return static_cast<double>(r.x1 - r.x0) * static_cast<double>(r.y1 - r.y0);
}

bool empty(const PixelRect& r) {
    return r.x0 >= r.x1 || r.y0 >= r.y1;
}

PixelRect common(const PixelRect& a, const PixelRect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

PixelRect around_both(const PixelRect& a, const PixelRect& b) {
    if (empty(a) || empty(b)) return empty(a) ? b : a;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

// A moving average: single calls are noisy, and the first one of a kind may wait for a compiler.
void learn(double& ms_per_pixel, double ms, double pixel_count) {
    if (pixel_count > 0) ms_per_pixel += 0.3 * (std::min(ms / pixel_count, 4 * ms_per_pixel) - ms_per_pixel);
}

}  // namespace

LivePane::LivePane(Session& session, Renderer& renderer, VkFormat format, const ViewChoice& choice)
    : session_(&session), renderer_(&renderer), choice_(&choice), picture_(session.context(), format) {}

PixelSize LivePane::full_size() const {
    return {std::max(1, picture_.size().width / choice_->reduction),
            std::max(1, picture_.size().height / choice_->reduction)};
}

void LivePane::set_renderer_size(PixelSize size) {
    if (renderer_size() != size) {
        renderer_->resize(size.width, size.height);
        mark_all_stale();
    }
    if (shows_layers() && layers_.size() != size) {
        layers_.reset(size, choice_->palette.view);
        mark_all_stale();
    }
}

void LivePane::resize(PixelSize size) {
    if (size == picture_.size()) return;
    picture_.resize(size);
    set_renderer_size(full_size());
    if (stale_.empty()) mark_all_stale();  // the renderer had that size from the start
    if (!in_stroke_) in_motion();
}

void LivePane::show_columns(int x0, int x1) {
    const PixelRect before = on_screen();
    shown_x0_ = x0;
    shown_x1_ = x1;
    // repaint() left out what was not on screen.
    const PixelRect now = on_screen();
    if (now.x0 < before.x0) repaint({now.x0, 0, before.x0, now.y1});
    if (now.x1 > before.x1) repaint({before.x1, 0, now.x1, now.y1});
}

// The renderer's pixels of the columns on screen.
PixelRect LivePane::on_screen() const {
    const double scale = static_cast<double>(renderer_->width()) / std::max(1, picture_.size().width);
    return {static_cast<int>(std::floor(shown_x0_ * scale)), 0,
            std::min(renderer_->width(), static_cast<int>(std::ceil(shown_x1_ * scale))),
            renderer_->height()};
}

void LivePane::choose_view() {
    if (shows_layers()) layers_.reset(renderer_size(), choice_->palette.view);
    in_motion();  // a coarse picture of it at once, and nothing left of another view
}

void LivePane::in_motion() {
    phase_ = Phase::moving;
    passes_ms_.clear();
    last_motion_ = Clock::now();
}

void LivePane::restart() {
    set_renderer_size(full_size());
    mark_all_stale();
    phase_ = Phase::stale;
}

void LivePane::begin_stroke(bool of_mask) {
    repaints_ = of_mask && can_repaint();
    mask_due_ = {};
    if (repaints_) return;
    set_renderer_size(full_size());
    if (phase_ == Phase::moving) mark_all_stale();
    in_stroke_ = true;
    traced_.clear();
    phase_ = Phase::stale;
}

void LivePane::after_dab() {
    const auto dab = session_->last_dab();
    if (!dab) return;
    const Scene& scene = session_->scene();
    const auto centre =
        project(scene.camera, scene.origin, renderer_->width(), renderer_->height(), dab->centre);
    if (!centre) return;
    const double depth = glm::length(glm::dvec3(dab->centre) + scene.origin - scene.camera.eye);
    const double px_per_unit =
        0.5 * renderer_->height() / (std::tan(glm::radians(scene.camera.fov_deg) / 2) * depth);
    const double reach = static_cast<double>(dab->radius) * px_per_unit;
    const auto around = [](double at, double by) {
        return static_cast<int>(std::floor(std::clamp(at + by, -1e6, 1e6)));
    };
    const PixelRect brush{around(centre->x, -reach), around(centre->y, -reach), around(centre->x, reach) + 1,
                          around(centre->y, reach) + 1};
    const PixelRect near = window_around(*centre, kLiveWindow, renderer_->width(), renderer_->height());
    if (repaints_) {
        mask_due_ = around_both(mask_due_, common(around_both(brush, near), whole()));
        return;
    }
    stale_.mark(brush, StaleTiles::urgent);
    stale_.mark(near, StaleTiles::late);
    pass_pixels_ = kNotWhole;
    focus_ = *centre;
    live_ms_ = 0;
}

void LivePane::cancel_stroke(bool changed) {
    const bool repainted = repaints_;
    end_stroke(changed);
    if (changed && !repainted) restart();
}

void LivePane::end_stroke(bool changed) {
    if (std::exchange(repaints_, false)) return;
    in_stroke_ = false;
    if (changed) start_sampling();
    phase_ = stale_.count() > 0 ? Phase::stale : Phase::sampling;
}

void LivePane::start_sampling() {
    phase_ = Phase::sampling;
    next_row_ = 0;
    sampling_since_ = Clock::now();
    if (!shows_layers()) renderer_->restart();
}

bool LivePane::idle() const {
    if (in_stroke_) return stale_.count() == 0;
    return phase_ == Phase::sampling && (shows_layers() || samples() >= choice_->sample_limit);
}

bool LivePane::covered() const {
    return phase_ != Phase::moving && stale_.count() == 0 && renderer_size() == full_size();
}

bool LivePane::take_changed() {
    return std::exchange(changed_, false);
}

int LivePane::samples() const {
    return phase_ == Phase::sampling && !shows_layers() ? renderer_->samples() : 0;
}

double LivePane::progress() const {
    const double fresh = stale_.fresh_share();
    if (phase_ == Phase::moving) return 0;
    if (shows_layers()) return fresh;
    if (phase_ == Phase::stale) return 0.3 * fresh;
    return samples() > 0 ? 1 : 0.3 + 0.7 * next_row_ / std::max(1, renderer_->height());
}

double LivePane::pass_ms() const {
    if (passes_ms_.empty()) return 0;
    std::vector<double> sorted = passes_ms_;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
}

bool LivePane::step(double slice_ms, double moving_ms) {
    if (phase_ == Phase::moving && ms_since(last_motion_) < kStillAfterMs) {
        trace_moving(moving_ms);
        return true;
    }
    if (phase_ == Phase::moving) restart();
    if (phase_ == Phase::stale) {
        trace_stale(slice_ms);
    } else {
        trace_sample(slice_ms);
    }
    return false;
}

// One window of what the view shows, in the quality that is there at once.
double LivePane::trace(const PixelRect& window) {
    double ms = 0;
    if (shows_layers()) {
        ms = renderer_->trace_layers(window, choice_->palette.view == View::steps);
        layers_.collect(*renderer_, window, choice_->count, *session_);
        layers_.paint(window, choice_->palette);
    } else {
        ms = renderer_->render(window, Quality::preview);
        if (veiled()) {
            if (veil_.size() != renderer_size()) veil_.reset(renderer_size());
            ms += renderer_->trace_layers(window);
            veil_.collect(*renderer_, window);
        }
    }
    learn(preview_ms_, ms, pixels(window));
    show(window);
    return ms;
}

void LivePane::trace_moving(double moving_ms) {
    const PixelSize full = full_size();
    const double share = static_cast<double>(shown_x1_ - shown_x0_) / std::max(1, picture_.size().width);
    const double wanted = static_cast<double>(full.width) * full.height * share;  // pixels
    const double affordable = moving_ms / preview_ms_;
    int divide = 1;
    while (divide < kCoarsest && wanted / (divide * divide) > affordable) ++divide;
    set_renderer_size({std::max(1, full.width / divide), std::max(1, full.height / divide)});
    trace_ms_ = trace(on_screen());
}

void LivePane::trace_stale(double slice_ms) {
    if (stale_.count() > 0) {
        const PixelRect slice = stale_.next(focus_, slice_ms / std::max(1e-9, preview_ms_));
        const double ms = trace(slice);
        stale_.clear(slice);
        pass_ms_ += ms;
        pass_pixels_ += pixels(slice);
        traced_.push_back(slice);
        if (in_stroke_) {
            live_ms_ += ms;
            if (stale_.urgent_count() == 0) trace_ms_ = live_ms_;
        }
    }
    if (stale_.count() > 0 || in_stroke_) return;
    if (shows_layers()) finish_pass();
    start_sampling();
    pass_ms_ = pass_pixels_ = 0;
}

void LivePane::trace_sample(double slice_ms) {
    const PixelRect slice = slice_from(next_row_, slice_ms);
    const double ms = renderer_->render(slice, Quality::full);
    learn(sample_ms_, ms, pixels(slice));
    if (next_row_ == 0) pass_ms_ = pass_pixels_ = 0;
    pass_ms_ += ms;
    pass_pixels_ += pixels(slice);
    next_row_ = slice.y1;
    if (next_row_ < renderer_->height()) return;
    if (slice.y0 > 0) renderer_->end_pass();  // one slice of all rows counts itself
    next_row_ = 0;
    finish_pass();
    if (samples() >= std::min(kFirstShown, choice_->sample_limit) ||
        ms_since(sampling_since_) > kShownAtLatestMs)
        show(whole());
}

// The time of a pass counts where the pass traced every pixel once.
void LivePane::finish_pass() {
    if (pass_pixels_ != pixels(whole())) return;
    trace_ms_ = pass_ms_;
    passes_ms_.push_back(pass_ms_);
    if (passes_ms_.size() > kPassesKept) passes_ms_.erase(passes_ms_.begin());
}

void LivePane::show(const PixelRect& window) {
    if (shows_layers()) {
        picture_.write(layers_.rgba(), layers_.size(), window);
    } else if (veiled() && veil_.size() == renderer_size()) {
        veil_.take(picture_.read(*renderer_, window), window);
        show_veiled(window);
    } else {
        picture_.copy(*renderer_, window);
    }
    changed_ = true;
}

void LivePane::show_veiled(const PixelRect& window) {
    veil_.paint(window, choice_->veil ? session_->mask() : nullptr,
                session_->scene().objects.front().displacement.wrap);
    picture_.write(veil_.rgba(), veil_.size(), window);
    changed_ = true;
}

void LivePane::repaint_due() {
    const PixelRect due = std::exchange(mask_due_, {});
    if (empty(due) || !can_repaint()) return;
    show_veiled(due);
    traced_.push_back(due);
}

// Nothing is traced again where it is known what lies under each pixel.
void LivePane::mask_changed() {
    if (in_stroke_ || shows_layers() || phase_ == Phase::moving) return;
    if (repaints_) return repaint_due();
    if (veil_.knows_all() && veil_.size() == renderer_size()) {
        show_veiled(whole());
    } else {
        restart();
    }
    if (!choice_->veil) veil_.reset({});
}

// What is stale keeps its old colours until it is traced.
void LivePane::repaint(const PixelRect& window) {
    if (!shows_layers() || layers_.size() != renderer_size()) return;
    const PixelRect wanted = common(common(window, on_screen()), whole());
    if (empty(wanted)) return;
    for (int row = wanted.y0 / kTile; row * kTile < wanted.y1; ++row) {
        for (int x0 = wanted.x0 / kTile; x0 * kTile < wanted.x1;) {
            int x1 = x0;
            while (x1 * kTile < wanted.x1 && !stale_.stale_at(x1, row)) ++x1;
            const PixelRect run = common(wanted, {x0 * kTile, row * kTile, x1 * kTile, (row + 1) * kTile});
            layers_.paint(run, choice_->palette);
            if (!empty(run)) show(run);
            x0 = x1 + 1;
        }
    }
}

// Whole rows of pixels of a sample from `row` on.
PixelRect LivePane::slice_from(int row, double slice_ms) const {
    const PixelSize size = renderer_size();
    const double rows = slice_ms / std::max(1e-9, sample_ms_ * size.width);
    const int taken = static_cast<int>(std::clamp(rows, 2.0, 1e6));
    return {0, row, size.width, std::min(size.height, row + taken)};
}

void LivePane::mark_all_stale() {
    stale_.reset(renderer_->width(), renderer_->height());
    focus_ = {renderer_->width() * 0.5, renderer_->height() * 0.5};
    pass_ms_ = pass_pixels_ = 0;
}

}  // namespace relievo::gui
