// See pen_track.h.
#include "editor/gui/pen_track.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace relievo::gui {

std::deque<PenSample>::iterator PenTrack::find(PenSample::Kind kind, double x, double y) {
    const auto on_pixel = [&](const PenSample& sample) {
        return std::floor(sample.x) == std::floor(x) && std::floor(sample.y) == std::floor(y);
    };
    for (auto sample = samples_.begin(); sample != samples_.end(); ++sample) {
        if (sample->kind != kind) continue;
        const auto after = std::next(sample);
        const bool newest = after == samples_.end();
        if (kind != PenSample::Kind::move || newest || on_pixel(*sample) || on_pixel(*after)) return sample;
    }
    return samples_.end();
}

const PenTouch& PenTrack::touch_at(PenSample::Kind kind, double x, double y) {
    const auto found = find(kind, x, y);
    if (found == samples_.end()) return now_;
    now_ = found->touch;
    const auto passed = static_cast<std::size_t>(std::distance(samples_.begin(), found)) + 1;
    samples_.erase(samples_.begin(), found + 1);
    old_ -= std::min(old_, passed);
    return now_;
}

bool PenTrack::settle() {
    const PenTouch before = now_;
    if (old_ > 0) now_ = samples_[old_ - 1].touch;
    samples_.erase(samples_.begin(), samples_.begin() + static_cast<std::ptrdiff_t>(old_));
    old_ = samples_.size();
    return now_ != before;
}

}  // namespace relievo::gui
