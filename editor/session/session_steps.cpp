// Steps back and forth. What they do to map, mask and colours is done at once; to show it takes long where a large map
// has changed all over, and can be stopped.
#include <algorithm>
#include <stdexcept>

#include "editor/session/session_state.h"

namespace relievo {
namespace {

// About as much as the device is given within a tenth of a second.
constexpr int kSide = 2048;  // texels
constexpr std::int64_t kBatch = std::int64_t{kSide} * kSide;

using Rects = std::vector<TexelRect>;

std::vector<Rects> in_batches(const Rects& rects) {
    std::vector<Rects> batches;
    std::int64_t left = 0;  // of the last batch
    for (const TexelRect& rect : rects)
        for (int y = rect.y0; y < rect.y1; y += kSide)
            for (int x = rect.x0; x < rect.x1; x += kSide) {
                const TexelRect piece{x, y, std::min(x + kSide, rect.x1), std::min(y + kSide, rect.y1)};
                if (left <= 0) {
                    batches.emplace_back();
                    left = kBatch;
                }
                batches.back().push_back(piece);
                left -= piece.area();
            }
    return batches;
}

}  // namespace

Session::State::Change Session::State::swap_step(bool forth) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    Change change{forth ? sculptor->redo() : sculptor->undo(), sculptor->take_painted()};
    times = {};
    times.edit_ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    if (!change.heights.empty()) ++revision;
    if (!change.painted.empty()) ++colour_revision;
    return change;
}

void Session::State::show(const Change& change, const Advance& advance, Change& shown) {
    if (!view) return;
    const std::vector<Rects> heights = in_batches(change.heights), painted = in_batches(change.painted);
    const auto count = static_cast<double>(heights.size() + painted.size());
    int done = 0;
    for (const Rects& batch : heights) {
        tell(advance, done++ / count, kAllAsItWas);
        shown.heights.insert(shown.heights.end(), batch.begin(), batch.end());
        StageTimes part;
        view->upload(file.map, batch, part);
        times.upload_ms += part.upload_ms;
        times.bounds_ms += part.bounds_ms;
        times.refit_ms += part.refit_ms;
    }
    for (const Rects& batch : painted) {
        tell(advance, done++ / count, kAllAsItWas);
        shown.painted.insert(shown.painted.end(), batch.begin(), batch.end());
        view->upload_colours(colours.view(), batch, times);
    }
}

bool Session::State::take_step(bool forth, const Advance& advance) {
    require_no_stroke();
    if (!(forth ? sculptor->can_redo() : sculptor->can_undo())) return false;
    tell(advance, 0, kAllAsItWas);
    const auto book = [&] {
        forth ? redo_step() : undo_step();
        forth ? recorder->record(RedoOp{}) : recorder->record(UndoOp{});
    };
    const Change change = swap_step(forth);
    Change shown;
    try {
        show(change, advance, shown);
    } catch (const Stopped&) {
        swap_step(!forth);
        Change again;
        show(shown, {}, again);
        throw;
    } catch (...) {  // what happened to the map is recorded even if the device fails to show it
        book();
        throw;
    }
    book();
    if (!change.heights.empty() || !change.painted.empty()) restart_image();
    return true;
}

bool Session::undo(const Advance& advance) { return state_->take_step(false, advance); }

bool Session::redo(const Advance& advance) { return state_->take_step(true, advance); }

bool Session::revert(const Advance& advance) {
    const bool ahead = state_->steps.saved_is_ahead();
    if (!ahead && !state_->steps.saved_is_behind()) return false;
    const double steps = static_cast<double>(std::max<std::size_t>(1, state_->steps.steps_to_saved()));
    int taken = 0;
    const auto leave_all_as_it_was = [&] {
        for (; taken > 0; --taken) state_->take_step(!ahead, {});
    };
    try {
        for (; unsaved(); ++taken) {
            const Advance part = within(advance, std::min(taken / steps, 1.0), std::min((taken + 1) / steps, 1.0));
            if (state_->take_step(ahead, part)) continue;
            leave_all_as_it_was();  // the way is cut off
            return false;
        }
    } catch (const Stopped&) {
        leave_all_as_it_was();
        throw;
    }
    return true;
}

}  // namespace relievo
