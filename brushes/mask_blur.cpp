// Softening of a mask's borders, row by row.
#include "brushes/mask_blur.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "brushes/seams.h"
#include "brushes/surface.h"

namespace relievo {
namespace {

// A row of the mask and those beside it, as they were before. At the map's border its own in the missing one's place.
struct Rows {
    const std::uint16_t *below, *own, *above;
    int width;
};

bool equal(const std::uint16_t* a, const std::uint16_t* b, int count) {
    return std::memcmp(a, b, static_cast<std::size_t>(count) * sizeof *a) == 0;
}

// Far from the mask's borders nothing changes: spares asking who owns texels there.
bool is_even(const Rows& rows, int begin, int end) {
    const int first = std::max(begin - 1, 0), last = std::min(end, rows.width - 1);
    return equal(rows.own + first, rows.own + first + 1, last - first) &&
           equal(rows.own + begin, rows.below + begin, end - begin) &&
           equal(rows.own + begin, rows.above + begin, end - begin);
}

bool is_even(const Rows& rows, int x) {
    const std::uint16_t own = rows.own[x];
    return rows.below[x] == own && rows.above[x] == own && (x == 0 || rows.own[x - 1] == own) &&
           (x + 1 == rows.width || rows.own[x + 1] == own);
}

class Blur {
  public:
    Blur(HeightMap& mask, const Surface& surface, const Seams& seams)
        : mask_(mask), surface_(surface), seams_(seams), below_(row(0)), own_(row(0)) {}

    // All rows in turn, from 0 on.
    void change_row(int y) {
        if (y > 0) below_.swap(own_);
        own_ = row(y);
        const std::uint16_t* const above = y + 1 < mask_.height() ? &mask_.texels()[mask_.index(0, y + 1)] : own_.data();
        const Rows rows{below_.data(), own_.data(), above, mask_.width()};
        constexpr int kRun = 64;
        for (int begin = 0; begin < rows.width; begin += kRun) {
            const int end = std::min(begin + kRun, rows.width);
            if (is_even(rows, begin, end)) continue;
            for (int x = begin; x < end; ++x)
                if (!is_even(rows, x) && surface_.owned(x, y)) mask_.set(x, y, blurred(rows, x, y));
        }
    }

  private:
    std::vector<std::uint16_t> row(int y) const {
        const auto texels = mask_.texels().subspan(mask_.index(0, y), static_cast<std::size_t>(mask_.width()));
        return {texels.begin(), texels.end()};
    }

    std::uint16_t blurred(const Rows& rows, int x, int y) const {
        const std::uint32_t own = rows.own[x];
        std::uint32_t sum = 0, count = 0;
        const auto add = [&](int i, int j, std::uint16_t value) {
            if (surface_.owned(i, j) || seams_.is_gutter(i, j)) sum += value, ++count;
        };
        if (x > 0) add(x - 1, y, rows.own[x - 1]);
        if (x + 1 < rows.width) add(x + 1, y, rows.own[x + 1]);
        if (y > 0) add(x, y - 1, rows.below[x]);
        if (y + 1 < mask_.height()) add(x, y + 1, rows.above[x]);
        return static_cast<std::uint16_t>(count == 0 ? own : (own + (sum + count / 2) / count + 1) / 2);
    }

    HeightMap& mask_;
    const Surface& surface_;
    const Seams& seams_;
    std::vector<std::uint16_t> below_, own_;  // as they were before
};

}  // namespace

void blur_once(HeightMap& mask, const Surface& surface, const Seams& seams, const Advance& advance) {
    constexpr int kRows = 64;  // of the largest map some hundredths of a second
    Blur blur(mask, surface, seams);
    for (int y = 0; y < mask.height(); ++y) {
        if (y % kRows == 0)
            tell(advance, static_cast<double>(y) / mask.height(), "Stopped: all is as it was");
        blur.change_row(y);
    }
}

}  // namespace relievo
