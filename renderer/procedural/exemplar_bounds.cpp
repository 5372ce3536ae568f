// See exemplar_bounds.h.
#include "renderer/procedural/exemplar_bounds.h"

#include <algorithm>
#include <bit>

namespace relievo {
namespace {

void widen(ExemplarBounds::Range& range, const ExemplarBounds::Range& other) {
    range.low = std::min(range.low, other.low);
    range.high = std::max(range.high, other.high);
}

// A wrapped stretch as at most two inside [0, size), ends included. Returns their number.
int split(int first, int count, int size, int (&from)[2], int (&to)[2]) {
    from[0] = first, to[0] = first + count - 1;
    if (count >= size) return from[0] = 0, to[0] = size - 1, 1;
    if (to[0] < size) return 1;
    from[1] = 0, to[1] = to[0] - size;
    to[0] = size - 1;
    return 2;
}

}  // namespace

ExemplarBounds::ExemplarBounds(int width, int height, const std::uint16_t* texels) {
    Level first{width, height, {}};
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    first.nodes.reserve(count);
    for (std::size_t i = 0; i < count; ++i) first.nodes.push_back({texels[i], texels[i]});
    levels_.push_back(std::move(first));
    while (levels_.back().width > 1 || levels_.back().height > 1) {
        const Level& fine = levels_.back();
        Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
        coarse.nodes.resize(static_cast<std::size_t>(coarse.width) * static_cast<std::size_t>(coarse.height));
        for (int y = 0; y < fine.height; ++y)
            for (int x = 0; x < fine.width; ++x)
                widen(coarse.nodes[static_cast<std::size_t>(y / 2 * coarse.width + x / 2)],
                      fine.nodes[static_cast<std::size_t>(y * fine.width + x)]);
        levels_.push_back(std::move(coarse));
    }
}

void ExemplarBounds::include(Range& range, int x0, int y0, int x1, int y1) const {
    const int side = std::max(x1 - x0, y1 - y0) + 1;
    const int level = std::clamp(static_cast<int>(std::bit_width(static_cast<unsigned>(side))) - 3, 0,
                                 static_cast<int>(levels_.size()) - 1);
    const Level& nodes = levels_[static_cast<std::size_t>(level)];
    for (int y = y0 >> level; y <= y1 >> level; ++y)
        for (int x = x0 >> level; x <= x1 >> level; ++x)
            widen(range, nodes.nodes[static_cast<std::size_t>(y * nodes.width + x)]);
}

ExemplarBounds::Range ExemplarBounds::range(int x, int y, int columns, int rows) const {
    int x0[2], x1[2], y0[2], y1[2];
    const int across = split(x, columns, levels_[0].width, x0, x1),
              up = split(y, rows, levels_[0].height, y0, y1);
    Range range;
    for (int j = 0; j < up; ++j)
        for (int i = 0; i < across; ++i) include(range, x0[i], y0[j], x1[i], y1[j]);
    return range;
}

}  // namespace relievo
