// When long work gives its thread to a frame that shows how far it is. Without a GPU the frame of a large window takes as
// long as several pieces of the work; drawn at every chance, it would take most of the time.
#pragma once

#include <algorithm>

namespace relievo::gui {

class WorkPace {
  public:
    // In milliseconds of any clock. A frame that the user asks for need not be due.
    bool due(double now_ms) const {
        return frames_ < kFirstFrames || now_ms - drawn_ms_ >= std::max(kLeastMs, kWorkPerFrame * frame_ms_);
    }

    void drawn(double begin_ms, double end_ms) {
        ++frames_;
        frame_ms_ = end_ms - begin_ms;
        drawn_ms_ = end_ms;
    }

  private:
    static constexpr double kLeastMs = 50, kWorkPerFrame = 4;
    static constexpr int kFirstFrames = 2;  // Dear ImGui shows a new dialog from its second frame on
    double drawn_ms_ = 0, frame_ms_ = 0;
    int frames_ = 0;
};

}  // namespace relievo::gui
