// The double-precision reference beside an editing session: the session's side. The threads are in
// reference_workers.cpp.
#include "editor/session/live_reference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "editor/session/reference_workers.h"

namespace relievo {

namespace {

// The row's every other pixel is there from the pass before.
bool half_is_there(int step, int row) {
    return step < ReferencePicture::kCoarsest && row % (2 * step) == 0;
}

}  // namespace

int ReferencePicture::first_column(int step, int row) {
    return half_is_there(step, row) ? step : 0;
}

std::vector<int> ReferencePicture::columns(int width, int step, int row) {
    std::vector<int> columns;
    for (int x = first_column(step, row); x < width; x += half_is_there(step, row) ? 2 * step : step)
        columns.push_back(x);
    return columns;
}

ReferencePicture::ReferencePicture(int width, int height) : width_(width), height_(height) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    depth_.assign(pixels, std::numeric_limits<double>::quiet_NaN());
    object_.assign(pixels, 0);
}

void ReferencePicture::add(const Strip& strip) {
    const std::vector<int> xs = columns(width_, strip.step, strip.row);
    for (std::size_t i = 0; i < xs.size(); ++i) {
        depth_[index(xs[i], strip.row)] = strip.depth[i];
        object_[index(xs[i], strip.row)] = strip.object[i];
    }
}

std::optional<ReferencePicture::Sample> ReferencePicture::at(int x, int y) const {
    for (int step = 1; step <= kCoarsest; step *= 2) {
        const int px = x - x % step, py = y - y % step;
        const std::size_t i = index(px, py);
        if (!std::isnan(depth_[i])) return Sample{px, py, depth_[i], object_[i]};
    }
    return std::nullopt;
}

bool LiveReference::Frame::operator==(const Frame& other) const {
    return camera.eye == other.camera.eye && camera.look_at == other.camera.look_at &&
           camera.up == other.camera.up && camera.fov_deg == other.camera.fov_deg && width == other.width &&
           height == other.height;
}

LiveReference::LiveReference(const Session& session, std::function<void()> on_news, unsigned threads)
    : session_(&session), on_news_(std::move(on_news)), threads_(threads) {}

LiveReference::~LiveReference() = default;

bool LiveReference::snapshot_is_current() const {
    const Displacement& d = session_->scene().objects.front().displacement;
    return snapshot_ && snapshot_->revision == session_->map_revision() &&
           snapshot_->amplitude == d.amplitude && snapshot_->midlevel == d.midlevel;
}

bool LiveReference::is_current(int width, int height) const {
    return snapshot_is_current() && wanted_ == Frame{session_->scene().camera, width, height};
}

// Takes a copy of what edits change, when it has changed; a picture of the old surface is given up then.
void LiveReference::refresh_snapshot() {
    if (!workers_) workers_ = std::make_unique<ReferenceWorkers>(on_news_, threads_);
    if (snapshot_is_current()) return;
    stop();
    snapshot_ = take_snapshot(*session_);
}

void LiveReference::follow(int width, int height) {
    if (session_->in_stroke()) return;
    refresh_snapshot();
    const Frame frame{session_->scene().camera, width, height};
    if (wanted_ == frame) return;
    wanted_ = frame;
    picture_ = ReferencePicture(width, height);
    strips_taken_ = 0;
    strips_wanted_ = workers_->start({snapshot_, frame.camera, session_->scene().origin, width, height});
}

void LiveReference::stop() {
    wanted_.reset();
    if (workers_) workers_->stop();
}

std::vector<LiveReference::Rows> LiveReference::take() {
    std::vector<Rows> rows;
    if (!workers_ || !wanted_) return rows;
    for (const ReferencePicture::Strip& strip : workers_->take_strips()) {
        picture_.add(strip);
        ++strips_taken_;
        const int end = std::min(picture_.height(), strip.row + strip.step);
        // Helpers may finish out of order by a few rows; a new pass begins at the top again.
        const bool adjoins = !rows.empty() && std::abs(strip.row - rows.back().end) <= 4 * strip.step;
        if (adjoins) {
            rows.back() = {std::min(rows.back().begin, strip.row), std::max(rows.back().end, end)};
        } else {
            rows.push_back({strip.row, end});
        }
    }
    return rows;
}

double LiveReference::progress() const {
    return strips_wanted_ == 0 ? 0 : static_cast<double>(strips_taken_) / static_cast<double>(strips_wanted_);
}

void LiveReference::ask(const Ray& ray) {
    if (session_->in_stroke()) return;
    refresh_snapshot();
    workers_->ask(snapshot_, ray);
}

std::optional<ReferenceVerdict> LiveReference::take_verdict() {
    return workers_ ? workers_->take_verdict() : std::nullopt;
}

std::string LiveReference::take_trouble() {
    return workers_ ? workers_->take_trouble() : std::string();
}

}  // namespace relievo
