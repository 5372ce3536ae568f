// See procedural_cells.h.
#include "renderer/reference/procedural_cells.h"

#include <algorithm>
#include <cmath>

namespace relievo::reference {

void ProceduralCells::cover(int axis, double low, double high, Cells& cells) const {
    const auto a = static_cast<std::size_t>(axis);
    cells.low[a] = static_cast<std::int64_t>(std::floor(low));
    cells.high[a] = std::max(static_cast<std::int64_t>(std::ceil(high)), cells.low[a] + 1);
}

HeightRange ProceduralCells::range(const Cells& cells) const {
    const ProceduralSource::Range range =
        source_->range({cells.low[0], cells.low[1]}, glm::ivec2(cells.high[0], cells.high[1]));
    // A constant exemplar's one value is a whole count.
    if (range.low == range.high) {
        const auto count = static_cast<std::uint16_t>(std::lround(range.low * 65535));
        return {count, count};
    }
    return {static_cast<std::uint16_t>(std::max(std::floor(range.low * 65535), 0.0)),
            static_cast<std::uint16_t>(std::min(std::ceil(range.high * 65535), 65535.0))};
}

// Blocks are bounded as well wherever they begin.
std::int64_t ProceduralCells::cut(const Cells& cells, int axis) const {
    return cells.low[static_cast<std::size_t>(axis)] + cells.size(axis) / 2;
}

CellCounts ProceduralCells::counts(const Cells& single) const {
    const glm::ivec2 corner(single.low[0], single.low[1]);
    const auto at = [&](int x, int y) { return 65535 * source_->texel(corner + glm::ivec2(x, y)); };
    return cell_counts(single, at(0, 0), at(1, 0), at(0, 1), at(1, 1));
}

}  // namespace relievo::reference
