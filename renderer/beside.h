// Work of the renderer that may take long, on a thread of its own: meanwhile the one that asked for it tells how far it is,
// draws a window, and may stop it.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <functional>
#include <future>
#include <stdexcept>
#include <utility>

namespace relievo {

// Told which part is done, [0, 1], never less than before, on the thread that asked for the work: 0 before it begins, now and
// then while it runs, and 1 when all is made and nothing of it is in use yet. What it throws stops the work and is what the
// caller gets: all is then as it was. Empty: the work runs on the caller's thread.
using WorkProgress = std::function<void(double part)>;

// Where the two threads meet.
class WorkBoard {
  public:
    void tell(double part, double until) {
        part_ = part;
        until_ = until;
    }
    void stop() { stopped_ = true; }
    bool is_stopped() const { return stopped_; }

    // From one thread. Between two things told it creeps: half of the way in a second and a half, and never all of it.
    double shown() {
        const auto now = std::chrono::steady_clock::now();
        const double told = part_, until = until_;
        if (told > told_) {
            told_ = told;
            since_ = now;
        }
        const double seconds = std::chrono::duration<double>(now - since_).count();
        shown_ = std::max(shown_, told + std::max(0.0, until - told) * (1 - std::exp2(-seconds / 1.5)));
        return shown_;
    }

  private:
    std::atomic<double> part_ = 0, until_ = 0;
    std::atomic<bool> stopped_ = false;
    double told_ = 0, shown_ = 0;
    std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

// How far a piece of the work is, told from its thread.
class WorkPart {
  public:
    WorkPart() = default;  // nobody asks
    explicit WorkPart(WorkBoard& board) : board_(&board) {}

    // `done` of this piece, [0, 1]; what follows will not tell anything until `next`. Throws where the work is to end.
    void at(double done, double next) const {
        if (!board_) return;
        if (board_->is_stopped()) throw std::runtime_error("stopped");  // that nobody sees: run_beside() knows why
        board_->tell(place(done), place(next));
    }
    void at(double done) const { at(done, done); }
    WorkPart within(double begin, double end) const {
        WorkPart piece = *this;
        piece.begin_ = place(begin), piece.end_ = place(end);
        return piece;
    }

  private:
    double place(double part) const { return begin_ + (end_ - begin_) * part; }

    WorkBoard* board_ = nullptr;
    double begin_ = 0, end_ = 1;
};

// `work(WorkPart)`, and what it returns or throws.
template <typename Work>
auto run_beside(const WorkProgress& progress, const Work& work) {
    if (!progress) return work(WorkPart());
    constexpr auto kBetweenLooks = std::chrono::milliseconds(10);
    WorkBoard board;
    progress(0);
    auto made = std::async(std::launch::async, [&] { return work(WorkPart(board)); });
    std::exception_ptr stopped;
    // It goes on being told while the work comes to its end: a window is drawn by it.
    const auto look = [&](double part) {
        try {
            progress(part);
        } catch (...) {
            if (!stopped) stopped = std::current_exception();
            board.stop();
        }
    };
    while (made.wait_for(kBetweenLooks) != std::future_status::ready) look(board.shown());
    if (!stopped) {
        auto result = made.get();
        look(1);
        if (!stopped) return result;
    }
    std::rethrow_exception(stopped);
}

}  // namespace relievo
