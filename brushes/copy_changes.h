// What a dab's copies want of the texels, brought together: each on its own state of things, then all at
// once. Lists of a few megabytes wait for the end; what is more is summed up as it comes, so that memory
// follows the texels that the copies cover, not the number of copies. Both ways give the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "brushes/dab_tools.h"
#include "brushes/stroke_tiles.h"

namespace relievo {

class CopyChanges {
  public:
    static constexpr std::size_t kWaiting = std::size_t{16} << 20;  // bytes of lists that may wait

    // `add_up`: as adds_up() says. `stroke` outlives this.
    CopyChanges(std::size_t copies, bool add_up, StrokeTiles& stroke, std::size_t waiting = kWaiting)
        : add_up_(add_up), waiting_(waiting), stroke_(stroke), lists_(copies) {}

    // What copy `copy` wants, as dab_changes() gave it. Once for each copy, in any order, on any thread.
    void add(std::size_t copy, std::vector<TexelChange> changes);
    // Writes them to the stroke, after the last add().
    void apply();

  private:
    // Of one texel. Of a single change, `together` is what it is changed to; of several, the sum of their
    // steps or the largest.
    struct Sum {
        double together;
        float from;
        std::uint32_t changes;

        void add(const TexelChange& change, bool add_up);
        float to() const;
    };
    using SumTile = std::array<Sum, kTileTexels>;

    void sum_up(const std::vector<TexelChange>& changes);
    bool apply_plainly();
    void apply_lists();
    void apply_sums();

    const bool add_up_;
    const std::size_t waiting_;
    StrokeTiles& stroke_;
    std::mutex mutex_;
    std::vector<std::optional<std::vector<TexelChange>>> lists_;
    std::size_t bytes_ = 0;   // of the lists that wait
    std::size_t summed_ = 0;  // copies, the first ones
    std::vector<std::unique_ptr<SumTile>> tiles_;
};

}  // namespace relievo
