// Joins a pen's pressure to the pointer's events. Both tell of the same movements, but by different ways:
// GLFW knows positions alone, the pen's reader knows pressures too, and either may be ahead. They are joined
// by position, which both have from the display. What an X server (21.1) says about a device's movement is
// where the pointer was before it, so a sample belongs to an event when it or the sample after it lies on the
// event's pixel; the newest sample has none after it yet, and goes to an event that no other fits.
#pragma once

#include <cstddef>
#include <deque>

namespace relievo::gui {

struct PenTouch {
    double pressure = 1;  // [0, 1]; a mouse always presses fully
    bool eraser = false;  // the other end of the pen
    bool operator==(const PenTouch&) const = default;
};

struct PenSample {
    enum class Kind { move, press, release } kind = Kind::move;
    double x = 0, y = 0;  // window coordinates, with their fractions
    PenTouch touch;
};

class PenTrack {
  public:
    // Of every pointing device, mice too, in their order.
    void add(const PenSample& sample) { samples_.push_back(sample); }

    // What the pointer's next event carries; (x, y) where it is, in window coordinates. A press or release
    // takes the first sample of its kind: some come without a movement.
    const PenTouch& touch_at(PenSample::Kind kind, double x, double y);

    // After each round of events: samples that two rounds did not ask for are given up, the newest of them
    // is what the pen does now. True when that is new.
    bool settle();

    const PenTouch& now() const { return now_; }

  private:
    std::deque<PenSample>::iterator find(PenSample::Kind kind, double x, double y);

    std::deque<PenSample> samples_;
    std::size_t old_ = 0;  // of them, those that a round has passed by
    PenTouch now_;
};

// Where samples come from.
class PenReader {
  public:
    PenReader() = default;
    PenReader(const PenReader&) = delete;
    PenReader& operator=(const PenReader&) = delete;
    virtual ~PenReader() = default;
    virtual void read(PenTrack& track) = 0;  // those that came since the last call; waits for none
};

}  // namespace relievo::gui
