// The picture of the session in the window: panes, view and scale.
#include "editor/gui/live_picture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "editor/gui/map_value.h"
#include "renderer/stopwatch.h"

namespace relievo::gui {
namespace {

// Aims, all panes together: one call of the renderer, and one frame in motion.
constexpr double kSliceMs = 14, kLeastSliceMs = 5, kMovingMs = 32;
constexpr double kLeastError = 1e-7, kMostError = 1;
constexpr double kCostRank = 0.98;  // of the pixels: a few rays cost ten times the rest
constexpr double kLeastShare = 0.05;
constexpr double kSumUpMs = 700, kSumUpPixels = 3e5;

}  // namespace

LivePicture::LivePicture(Session& session, LiveReference& reference, VkFormat format)
    : session_(&session), reference_(&reference), format_(format) {
    choice_.palette.view = View::beauty;
    panes_.push_back(std::make_unique<LivePane>(session, session.renderer(), format, choice_));
}

std::vector<PictureStrip> LivePicture::strips() const {
    if (!is_split()) return {{&panes_.front()->picture(), 0, size().width}};
    const int middle = divider_px();
    return {{&panes_[0]->picture(), 0, middle}, {&panes_[1]->picture(), middle, size().width}};
}

int LivePicture::divider_px() const {
    return is_split() ? static_cast<int>(std::lround(divider_ * size().width)) : size().width;
}

void LivePicture::show_strips() {
    const auto all = strips();
    for (std::size_t i = 0; i < panes_.size(); ++i) panes_[i]->show_columns(all[i].x0, all[i].x1);
}

void LivePicture::resize(PixelSize size) {
    for (auto& pane : panes_) pane->resize(size);
    show_strips();
}

void LivePicture::set_reduction(int reduction) {
    if (reduction == choice_.reduction) return;
    choice_.reduction = reduction;
    restart();
}

void LivePicture::set_view(View view, const Advance& advance) {
    if (view == choice_.palette.view) return;
    if (shows_layers(view)) session_->make_ready(view == View::steps ? vulkan::Pass::counts : vulkan::Pass::aov, advance);
    choice_.palette.view = view;
    choice_.palette.reference = &reference_->picture();
    choice_.palette.units = error_units(session_->scene());
    if (view != View::error) reference_->stop();
    scale_due_ = scale_is_first_ = true;
    choice_.palette.scale = wanted_scale();
    errors_.assign(2, {});
    for (auto& pane : panes_) pane->choose_view();
}

void LivePicture::set_count(RayCount count) {
    if (count == choice_.count) return;
    choice_.count = count;
    scale_due_ = scale_is_first_ = true;
    for (auto& pane : panes_) pane->choose_view();
}

void LivePicture::compare_with(const std::optional<MethodChoice>& method, const Advance& advance) {
    if (!method) {
        if (!is_split()) return;
        panes_.pop_back();
        session_->stop_comparing();
        show_strips();
        return;
    }
    Renderer& renderer = session_->compare_with(*method, advance);
    if (!is_split()) {
        panes_.push_back(std::make_unique<LivePane>(*session_, renderer, format_, choice_));
        panes_.back()->resize(size());
    }
    errors_.assign(2, {});
    show_strips();
    panes_.back()->choose_view();
}

void LivePicture::set_divider(double share) {
    divider_ = std::clamp(share, kLeastShare, 1 - kLeastShare);
    show_strips();
}

Renderer& LivePicture::renderer_at(double x) {
    session_->show_edits();
    return panes_[is_split() && x >= divider_px() ? 1 : 0]->renderer();
}

int LivePicture::middle() const {
    return static_cast<int>(std::lround(to_renderer_x(divider_px())));
}

std::vector<RenderPart> LivePicture::parts() {
    Renderer& first = panes_.front()->renderer();
    if (!is_split()) return {{&first, 0, first.width()}};
    return {{&first, 0, middle()}, {&panes_.back()->renderer(), middle(), first.width()}};
}

DisplayPicture LivePicture::layers() const {
    const LayerImage &first = panes_.front()->layers(), &last = panes_.back()->layers();
    if (first.size() != last.size()) throw std::logic_error("LivePicture::layers in motion");
    DisplayPicture picture{first.size().width, first.size().height, first.rgba()};
    if (is_split()) put_columns(picture, last.rgba(), middle(), picture.width);
    return picture;
}

void LivePicture::come_to_rest(const Advance& advance) {
    constexpr double kTurnMs = 30;
    for (; progress() < 1; work(kTurnMs)) tell(advance, progress(), "Stopped: the picture was not saved");
}

double LivePicture::to_renderer_x(double x) const {
    return x * panes_.front()->renderer().width() / size().width;
}
double LivePicture::to_renderer_y(double y) const {
    return y * panes_.front()->renderer().height() / size().height;
}

void LivePicture::in_motion() {
    for (auto& pane : panes_) pane->in_motion();
}
void LivePicture::restart() {
    for (auto& pane : panes_) pane->restart();
}
void LivePicture::begin_stroke(bool of_mask) {
    for (auto& pane : panes_) pane->begin_stroke(of_mask);
}
void LivePicture::after_dab() {
    for (auto& pane : panes_) pane->after_dab();
}
void LivePicture::end_stroke(bool changed) {
    for (auto& pane : panes_) pane->end_stroke(changed);
    if (choice_.veil) follow_mask();  // what the stroke's window left out: copies by symmetry
}

void LivePicture::cancel_stroke(bool changed) {
    for (auto& pane : panes_) pane->cancel_stroke(changed);
    if (choice_.veil) follow_mask();
}

bool LivePicture::idle() const {
    return mask_seen_ == session_->mask_revision() &&
           std::all_of(panes_.begin(), panes_.end(), [](const auto& pane) { return pane->idle(); });
}

bool LivePicture::all_covered() const {
    return std::all_of(panes_.begin(), panes_.end(), [](const auto& pane) { return pane->covered(); });
}

bool LivePicture::take_changed() {
    bool changed = false;
    for (auto& pane : panes_) changed |= pane->take_changed();
    return changed;
}

std::vector<PixelRect> LivePicture::take_traced() {
    std::vector<PixelRect> traced = panes_.front()->take_traced();
    const double scale = 1 / to_renderer_x(1);
    const auto scaled = [&](int at) { return static_cast<int>(std::lround(at * scale)); };
    for (PixelRect& rect : traced)
        rect = {scaled(rect.x0), scaled(rect.y0), scaled(rect.x1), scaled(rect.y1)};
    return traced;
}

int LivePicture::samples() const {
    int least = panes_.front()->samples();
    for (const auto& pane : panes_) least = std::min(least, pane->samples());
    return least;
}

double LivePicture::progress() const {
    double least = 1;
    for (const auto& pane : panes_) least = std::min(least, pane->progress());
    return least;
}

void LivePicture::work(double budget_ms) {
    const auto start = Clock::now();
    session_->show_edits();
    const auto share = static_cast<double>(panes_.size());
    bool moved = false;
    double left_ms = budget_ms;
    if (mask_seen_ != session_->mask_revision()) follow_mask();
    do {
        if (idle()) break;
        const double slice_ms = std::clamp(left_ms, kLeastSliceMs, kSliceMs) / share;
        // Slice about slice, so that a noisy machine slows both methods alike.
        for (auto& pane : panes_)
            if (!pane->idle()) moved |= pane->step(slice_ms, kMovingMs / share);
        left_ms = budget_ms - ms_since(start);
    } while (!moved && left_ms > kLeastSliceMs);
    update_scale();
    follow_reference();
}

void LivePicture::set_mask_shown(bool shown) {
    mask_shown_ = shown;
    follow_mask();
}

// A mask that protects nothing costs nothing.
void LivePicture::follow_mask() {
    mask_seen_ = session_->mask_revision();
    const HeightMap* mask = session_->mask();
    const bool protects = mask && (session_->in_stroke() ||
                                   std::ranges::any_of(mask->texels(), [](std::uint16_t t) { return t > 0; }));
    choice_.veil = mask_shown_ && protects;
    for (auto& pane : panes_) pane->mask_changed();
}

// The reference follows when the picture stands still; until then its last picture is not of this surface.
void LivePicture::follow_reference() {
    if (view() != View::error) return;
    const PixelSize full = panes_.front()->full_size();
    const bool still = all_covered() && !session_->in_stroke();
    if (!reference_->is_current(full.width, full.height)) {
        reference_->stop();
        errors_.assign(2, {});
        if (!still) return;
        choice_.palette.units = error_units(session_->scene());
        reference_->follow(full.width, full.height);
        repaint(0, full.height);
    }
    for (const LiveReference::Rows& rows : reference_->take()) {
        repaint(rows.begin, rows.end);
        errors_due_ = true;
    }
    // Another method beside the same reference is to be summed up anew.
    errors_due_ = errors_due_ || !still;
    const bool complete = reference_->progress() >= 1;
    if (still && errors_due_ && (complete || ms_since(summed_up_) > kSumUpMs)) sum_up_errors(complete);
}

// While the reference is under way, not so many pixels that the interface has to wait.
void LivePicture::sum_up_errors(bool complete) {
    const PixelSize full = panes_.front()->full_size();
    int stride = 1;
    while (!complete && static_cast<double>(full.width) * full.height > kSumUpPixels * stride * stride)
        stride *= 2;
    for (std::size_t i = 0; i < panes_.size(); ++i)
        errors_[i] = panes_[i]->layers().errors(choice_.palette, stride);
    summed_up_ = Clock::now();
    errors_due_ = false;
}

void LivePicture::repaint(int row_begin, int row_end) {
    for (auto& pane : panes_) pane->repaint({0, row_begin, size().width, row_end});
}

// The scale stays while the picture moves or is sculpted, so that a colour keeps its meaning; but the first
// one of a view comes with its first pixels.
void LivePicture::update_scale() {
    const bool covered = all_covered();
    if (!shows_layers(view()) || view() == View::normals || session_->in_stroke()) return;
    scale_due_ = scale_due_ || !covered;
    if (!scale_due_ || !(covered || scale_is_first_)) return;
    scale_due_ = !covered;
    scale_is_first_ = scale_is_first_ && !covered;
    const ColourScale wanted = wanted_scale();
    if (wanted == choice_.palette.scale) return;
    choice_.palette.scale = wanted;
    repaint(0, size().height);
}

ColourScale LivePicture::wanted_scale() const {
    if (view() == View::error) return ColourScale::logarithmic(kLeastError, kMostError);
    if (view() == View::height) return ColourScale::diverging(round_limit(most_displacement()));
    double most = 0;
    for (const auto& pane : panes_) most = std::max(most, pane->layers().quantile(kCostRank));
    return ColourScale::heat(round_limit(most));
}

// Of any texel of any map: what the surface can reach without another edit.
double LivePicture::most_displacement() const {
    double most = 0;
    const Scene& scene = session_->scene();
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const auto texels = session_->map_of(i).texels();
        const auto [low, high] = std::minmax_element(texels.begin(), texels.end());
        for (const double counts : {static_cast<double>(*low), static_cast<double>(*high)})
            most = std::max(most, std::abs(displacement_of(scene.objects[i].displacement, counts)));
    }
    return most;
}

}  // namespace relievo::gui
