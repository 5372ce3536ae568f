// The double-precision reference beside an editing session: a snapshot of the surface, traced by threads of
// its own, coarse to fine, while the session goes on. Nothing here waits for them but the destructor.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/session/session.h"
#include "renderer/reference/reference.h"

namespace relievo {

// First hits through pixel centres, as far as they are known.
class ReferencePicture {
  public:
    static constexpr int kCoarsest = 16;  // every so many pixels each way at first, then half, down to 1

    // The pixels of one row that a pass adds: those at multiples of `step` that no coarser pass had.
    struct Strip {
        int step = 1, row = 0;
        std::vector<double> depth;          // along the unit ray; infinity where nothing is hit
        std::vector<std::uint32_t> object;  // + 1, 0 where nothing is hit
    };
    static std::vector<int> columns(int width, int step, int row);
    static int first_column(int step, int row);

    ReferencePicture() = default;
    ReferencePicture(int width, int height);
    void add(const Strip& strip);

    int width() const { return width_; }
    int height() const { return height_; }

    struct Sample {
        int x,
            y;  // the pixel it belongs to: the one that was asked for, or a coarser pass's to its upper left
        double depth;
        std::uint32_t object;
    };
    std::optional<Sample> at(int x, int y) const;

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    int width_ = 0, height_ = 0;
    std::vector<double> depth_;  // NaN: not known
    std::vector<std::uint32_t> object_;
};

// What the reference says about one ray.
struct ReferenceVerdict {
    std::optional<ReferenceHit> hit;
    ReferencePoint point;  // where it hits
    bool undecided = false;
};

struct ReferenceSnapshot;
class ReferenceWorkers;

class LiveReference {
  public:
    // `on_news` is called from other threads when there is something to take; `session` outlives this object,
    // and has a renderer where its scene has several objects. `threads`: 0 leaves one core to the interface.
    LiveReference(const Session& session, std::function<void()> on_news, unsigned threads = 0);
    ~LiveReference();  // waits for the rays under way
    LiveReference(const LiveReference&) = delete;
    LiveReference& operator=(const LiveReference&) = delete;

    // Wants the picture of the surface and camera as they are now; nothing happens where it is that already.
    // Not in a stroke: it would be out of date at once.
    void follow(int width, int height);
    void stop();  // wants no picture

    struct Rows {
        int begin, end;
    };
    // Moves what the threads have finished into picture(); the rows that look different since.
    std::vector<Rows> take();
    const ReferencePicture& picture() const { return picture_; }
    bool wants_picture() const { return wanted_.has_value(); }
    bool is_current(int width,
                    int height) const;  // the picture wanted is of the surface and camera as they are
    double progress() const;            // [0, 1]

    // Asks about one ray (rebased space) and the surface as it is now. A later question replaces this one.
    void ask(const Ray& ray);
    std::optional<ReferenceVerdict> take_verdict();

    std::string take_trouble();  // why the reference cannot work, once; else empty

  private:
    bool snapshot_is_current() const;
    void refresh_snapshot();

    const Session* session_;
    std::function<void()> on_news_;
    unsigned threads_;
    std::shared_ptr<const ReferenceSnapshot> snapshot_;
    struct Frame {
        Camera camera;
        int width, height;
        bool operator==(const Frame& other) const;
    };
    std::optional<Frame> wanted_;
    ReferencePicture picture_;
    std::size_t strips_taken_ = 0, strips_wanted_ = 0;
    std::unique_ptr<ReferenceWorkers> workers_;  // from the first wish on
};

}  // namespace relievo
