// What is traced next.
#include "editor/gui/live_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "editor/session/replay.h"
#include "editor/session/view_window.h"

namespace relievo::gui {
namespace {

constexpr int kTile = 64;              // pixels a side
constexpr double kSliceMs = 25;        // aim for one call of the renderer
constexpr double kMovingMs = 60;       // aim for one frame in motion
constexpr double kStillAfterMs = 160;  // without a change, the motion is over
constexpr int kCoarsest = 8;
// The first samples are noisier than the preview that they replace: they are shown together.
constexpr int kFirstShown = 4;
constexpr double kShownAtLatestMs = 3000;

double ms_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double pixels(const PixelRect& r) {
    return static_cast<double>(r.x1 - r.x0) * static_cast<double>(r.y1 - r.y0);
}

// A moving average: single calls are noisy, and the first one of a kind may wait for a compiler.
void learn(double& ms_per_pixel, double ms, double pixel_count) {
    if (pixel_count > 0) ms_per_pixel += 0.3 * (std::min(ms / pixel_count, 4 * ms_per_pixel) - ms_per_pixel);
}

}  // namespace

LivePicture::LivePicture(Session& session, VkFormat format)
    : session_(&session), picture_(session.context(), format) {}

PixelSize LivePicture::full_size() const {
    return {std::max(1, picture_.size().width / reduction_),
            std::max(1, picture_.size().height / reduction_)};
}

void LivePicture::set_renderer_size(PixelSize size) {
    if (renderer().width() == size.width && renderer().height() == size.height) return;
    renderer().resize(size.width, size.height);
    mark_all_stale();
}

void LivePicture::resize(PixelSize size) {
    if (size == picture_.size()) return;
    picture_.resize(size);
    set_renderer_size(full_size());
    if (!in_stroke_) in_motion();
}

void LivePicture::set_reduction(int reduction) {
    if (reduction == reduction_) return;
    reduction_ = reduction;
    set_renderer_size(full_size());
    phase_ = Phase::stale;
}

double LivePicture::to_renderer_x(double x) const {
    return x * session_->renderer().width() / picture_.size().width;
}
double LivePicture::to_renderer_y(double y) const {
    return y * session_->renderer().height() / picture_.size().height;
}

void LivePicture::in_motion() {
    phase_ = Phase::moving;
    last_motion_ = Clock::now();
}

void LivePicture::restart() {
    set_renderer_size(full_size());
    mark_all_stale();
    phase_ = Phase::stale;
}

void LivePicture::begin_stroke() {
    set_renderer_size(full_size());
    if (phase_ == Phase::moving) mark_all_stale();
    in_stroke_ = true;
    live_due_ = false;
    phase_ = Phase::stale;
}

void LivePicture::after_dab() {
    const auto dab = session_->last_dab();
    if (!dab) return;
    const Scene& scene = session_->scene();
    const auto centre =
        project(scene.camera, scene.origin, renderer().width(), renderer().height(), dab->centre);
    if (!centre) return;
    const double depth = glm::length(glm::dvec3(dab->centre) + scene.origin - scene.camera.eye);
    const double px_per_unit =
        0.5 * renderer().height() / (std::tan(glm::radians(scene.camera.fov_deg) / 2) * depth);
    mark_stale(*centre, static_cast<double>(dab->radius) * px_per_unit);
    live_due_ = true;
}

void LivePicture::end_stroke(bool changed) {
    in_stroke_ = false;
    live_due_ = false;
    if (changed) start_sampling();
    phase_ = stale_count_ > 0 ? Phase::stale : Phase::sampling;
}

void LivePicture::start_sampling() {
    phase_ = Phase::sampling;
    next_row_ = 0;
    sampling_since_ = Clock::now();
}

bool LivePicture::idle() const {
    if (in_stroke_) return !live_due_ && stale_count_ == 0;
    return phase_ == Phase::sampling && samples() >= sample_limit_;
}

bool LivePicture::take_changed() {
    return std::exchange(changed_, false);
}

int LivePicture::samples() const {
    return phase_ == Phase::sampling ? session_->renderer().samples() : 0;
}

double LivePicture::progress() const {
    const double tiles = std::max(1, tiles_x_ * tiles_y_);
    if (phase_ != Phase::sampling) return phase_ == Phase::moving ? 0 : 0.3 * (1 - stale_count_ / tiles);
    return samples() > 0 ? 1 : 0.3 + 0.7 * next_row_ / std::max(1, session_->renderer().height());
}

void LivePicture::set_sample_limit(int limit) {
    sample_limit_ = limit;
}

void LivePicture::work(double budget_ms) {
    const auto start = Clock::now();
    do {
        if (idle()) return;
        if (live_due_) {
            trace_live();
            return;  // the eye waits for this one
        }
        if (phase_ == Phase::moving && ms_since(last_motion_) < kStillAfterMs) {
            trace_moving();
            return;
        }
        if (phase_ == Phase::moving) restart();
        if (phase_ == Phase::stale) {
            trace_stale();
        } else {
            trace_sample();
        }
    } while (ms_since(start) < budget_ms);
}

void LivePicture::trace_moving() {
    const PixelSize full = full_size();
    const double affordable = kMovingMs / preview_ms_;  // pixels
    int divide = 1;
    while (divide<kCoarsest&& static_cast<double>(full.width) * full.height / (divide * divide)> affordable)
        ++divide;
    set_renderer_size({std::max(1, full.width / divide), std::max(1, full.height / divide)});
    const PixelRect all{0, 0, renderer().width(), renderer().height()};
    trace_ms_ = renderer().render(all, Quality::preview);
    learn(preview_ms_, trace_ms_, pixels(all));
    show(all);
}

void LivePicture::trace_live() {
    live_due_ = false;
    const auto dab = session_->last_dab();
    const Scene& scene = session_->scene();
    const auto centre =
        dab ? project(scene.camera, scene.origin, renderer().width(), renderer().height(), dab->centre)
            : std::nullopt;
    if (!centre) return;
    const PixelRect window = window_around(*centre, kLiveWindow, renderer().width(), renderer().height());
    session_->trace(window);
    trace_ms_ = session_->times().trace_ms;
    learn(preview_ms_, trace_ms_, pixels(window));
    show(window);
    clear_stale(window);
}

void LivePicture::trace_stale() {
    if (stale_count_ > 0) {
        const PixelRect slice = next_stale();
        learn(preview_ms_, renderer().render(slice, Quality::preview), pixels(slice));
        show(slice);
        clear_stale(slice);
    }
    if (stale_count_ > 0 || in_stroke_) return;
    start_sampling();
    renderer().restart();
}

void LivePicture::trace_sample() {
    const PixelRect slice = slice_from(next_row_, sample_ms_);
    const double ms = renderer().render(slice, Quality::full);
    learn(sample_ms_, ms, pixels(slice));
    pass_ms_ = next_row_ == 0 ? ms : pass_ms_ + ms;
    next_row_ = slice.y1;
    if (next_row_ < renderer().height()) return;
    if (slice.y0 > 0) renderer().end_pass();  // one slice of all rows counts itself
    next_row_ = 0;
    trace_ms_ = pass_ms_;
    if (samples() >= std::min(kFirstShown, sample_limit_) || ms_since(sampling_since_) > kShownAtLatestMs)
        show({0, 0, renderer().width(), renderer().height()});
}

void LivePicture::show(const PixelRect& window) {
    picture_.copy(renderer(), window);
    changed_ = true;
}

// Whole rows of pixels from `row` on, about kSliceMs worth of them.
PixelRect LivePicture::slice_from(int row, double ms_per_pixel) const {
    const PixelSize size{session_->renderer().width(), session_->renderer().height()};
    const double rows = kSliceMs / std::max(1e-9, ms_per_pixel * size.width);
    const int taken = static_cast<int>(std::clamp(rows, 8.0, 1e6));
    return {0, row, size.width, std::min(size.height, row + taken)};
}

// The first row of tiles that has stale ones, from its first to its last, with the rows below it while they
// are cheap enough.
PixelRect LivePicture::next_stale() const {
    const auto first = std::find(stale_.begin(), stale_.end(), 1);
    const int row = static_cast<int>(first - stale_.begin()) / tiles_x_;
    const auto row_begin = stale_.begin() + static_cast<std::ptrdiff_t>(row) * tiles_x_;
    int x0 = static_cast<int>(first - row_begin), x1 = x0;
    for (int x = x0; x < tiles_x_; ++x)
        if (row_begin[x]) x1 = x + 1;
    int rows = 1;
    if (stale_count_ == tiles_x_ * (tiles_y_ - row)) {
        const double row_ms = preview_ms_ * kTile * kTile * tiles_x_;
        rows = static_cast<int>(std::clamp(kSliceMs / std::max(1e-9, row_ms), 1.0, 1e4));
    }
    const Renderer& r = session_->renderer();
    return {x0 * kTile, row * kTile, std::min(r.width(), x1 * kTile),
            std::min(r.height(), (row + rows) * kTile)};
}

void LivePicture::mark_all_stale() {
    tiles_x_ = (renderer().width() + kTile - 1) / kTile;
    tiles_y_ = (renderer().height() + kTile - 1) / kTile;
    stale_.assign(static_cast<std::size_t>(tiles_x_) * static_cast<std::size_t>(tiles_y_), 1);
    stale_count_ = tiles_x_ * tiles_y_;
}

void LivePicture::mark_stale(const glm::dvec2& centre_px, double radius_px) {
    const auto tile_of = [](double px, int count) {
        return static_cast<int>(std::clamp(std::floor(px / kTile), 0.0, static_cast<double>(count - 1)));
    };
    const int x0 = tile_of(centre_px.x - radius_px, tiles_x_),
              x1 = tile_of(centre_px.x + radius_px, tiles_x_);
    const int y0 = tile_of(centre_px.y - radius_px, tiles_y_),
              y1 = tile_of(centre_px.y + radius_px, tiles_y_);
    for (int y = y0; y <= y1; ++y) {
        for (int x = x0; x <= x1; ++x) {
            std::uint8_t& tile = stale_[static_cast<std::size_t>(y * tiles_x_ + x)];
            stale_count_ += tile ? 0 : 1;
            tile = 1;
        }
    }
}

// Tiles that the rectangle covers whole.
void LivePicture::clear_stale(const PixelRect& traced) {
    const Renderer& r = session_->renderer();
    for (int y = 0; y < tiles_y_; ++y) {
        for (int x = 0; x < tiles_x_; ++x) {
            const bool covered = x * kTile >= traced.x0 &&
                                 std::min(r.width(), (x + 1) * kTile) <= traced.x1 &&
                                 y * kTile >= traced.y0 && std::min(r.height(), (y + 1) * kTile) <= traced.y1;
            std::uint8_t& tile = stale_[static_cast<std::size_t>(y * tiles_x_ + x)];
            if (!covered || !tile) continue;
            tile = 0;
            --stale_count_;
        }
    }
}

}  // namespace relievo::gui
