// See cell_ranges.h.
#include "renderer/reference/cell_ranges.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace relievo::reference {
namespace {

std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
    const std::int64_t quotient = a / b;
    return quotient * b > a ? quotient - 1 : quotient;
}

int differing_bits(std::int64_t a, std::int64_t b) {
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(a ^ b)));
}

void include(HeightRange& range, const HeightRange& other) {
    range.low = std::min(range.low, other.low);
    range.high = std::max(range.high, other.high);
}

}  // namespace

std::int64_t CellRanges::Axis::local(std::int64_t cell) const {
    if (texels == 1) return 0;
    return repeat ? cell - floor_divide(cell, texels) * texels : cell + 1;
}

std::int64_t CellRanges::Axis::texel(std::int64_t cell) const {
    if (repeat) return cell - floor_divide(cell, texels) * texels;
    return std::clamp<std::int64_t>(cell, 0, texels - 1);
}

// First and last column of the cells [low, high): the whole axis where they reach over a period's end.
void CellRanges::Axis::span(std::int64_t low, std::int64_t high, std::int64_t& first,
                            std::int64_t& last) const {
    first = local(low);
    last = local(high - 1);
    if (last - first != high - 1 - low) first = 0, last = cells - 1;
}

CellRanges::CellRanges(const ReferenceTexels<std::uint16_t>& map, Wrap wrap) : texels_(map.texels) {
    const bool repeat = wrap == Wrap::repeat;
    const std::array<std::int64_t, 2> size{map.width, map.height};
    for (std::size_t a = 0; a < 2; ++a)
        axes_[a] = {size[a], repeat || size[a] == 1 ? size[a] : size[a] + 1, repeat};
    build();
}

void CellRanges::cover(int axis, double low, double high, Cells& cells) const {
    const auto a = static_cast<std::size_t>(axis);
    const Axis& info = axes_[a];
    if (info.texels == 1) {
        cells.low[a] = 0, cells.high[a] = 1;
        return;
    }
    auto first = static_cast<std::int64_t>(std::floor(low));
    auto end = std::max(static_cast<std::int64_t>(std::ceil(high)), first + 1);
    if (!info.repeat) {
        first = std::clamp<std::int64_t>(first, -1, info.texels - 1);
        end = std::clamp<std::int64_t>(end, first + 1, info.texels);
    }
    cells.low[a] = first;
    cells.high[a] = end;
}

// Texels under the columns [x0, x1] and rows [y0, y1] of the pyramid, right and upper neighbours included.
HeightRange CellRanges::scan(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) const {
    const std::int64_t shift_x = axes_[0].cells > axes_[0].texels ? 1 : 0;
    const std::int64_t shift_y = axes_[1].cells > axes_[1].texels ? 1 : 0;
    HeightRange range;
    for (std::int64_t y = y0 - shift_y; y <= y1 - shift_y + 1; ++y) {
        const std::int64_t row = axes_[1].texel(y);
        for (std::int64_t x = x0 - shift_x; x <= x1 - shift_x + 1; ++x) {
            const std::uint16_t count = at(axes_[0].texel(x), row);
            include(range, {count, count});
        }
    }
    return range;
}

void CellRanges::build() {
    constexpr std::int64_t kSide = std::int64_t{1} << kFirstLevel;
    std::int64_t width = (axes_[0].cells + kSide - 1) / kSide, height = (axes_[1].cells + kSide - 1) / kSide;
    Level first{width, height, {}};
    first.nodes.reserve(static_cast<std::size_t>(width * height));
    for (std::int64_t y = 0; y < height; ++y) {
        for (std::int64_t x = 0; x < width; ++x) {
            first.nodes.push_back(scan(x * kSide, y * kSide, std::min((x + 1) * kSide, axes_[0].cells) - 1,
                                       std::min((y + 1) * kSide, axes_[1].cells) - 1));
        }
    }
    levels_.push_back(std::move(first));
    while (width > 1 || height > 1) {
        const Level& fine = levels_.back();
        width = (width + 1) / 2, height = (height + 1) / 2;
        Level coarse{width, height, std::vector<HeightRange>(static_cast<std::size_t>(width * height))};
        for (std::int64_t y = 0; y < fine.height; ++y) {
            for (std::int64_t x = 0; x < fine.width; ++x) {
                include(coarse.nodes[static_cast<std::size_t>(y / 2 * width + x / 2)],
                        fine.nodes[static_cast<std::size_t>(y * fine.width + x)]);
            }
        }
        levels_.push_back(std::move(coarse));
    }
}

HeightRange CellRanges::range(const Cells& cells) const {
    std::int64_t x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    axes_[0].span(cells.low[0], cells.high[0], x0, x1);
    axes_[1].span(cells.low[1], cells.high[1], y0, y1);
    if (x1 - x0 < 4 && y1 - y0 < 4) return scan(x0, y0, x1, y1);
    // Two levels under the node that holds all of it: at most 4 x 4 nodes, and a long thin block stays thin.
    const int level = std::max(std::max(differing_bits(x0, x1), differing_bits(y0, y1)) - 2, kFirstLevel);
    const Level& nodes = levels_[static_cast<std::size_t>(level - kFirstLevel)];
    HeightRange range;
    for (std::int64_t y = y0 >> level; y <= y1 >> level; ++y) {
        for (std::int64_t x = x0 >> level; x <= x1 >> level; ++x)
            include(range, nodes.nodes[static_cast<std::size_t>(y * nodes.width + x)]);
    }
    return range;
}

std::int64_t CellRanges::cut(const Cells& cells, int axis) const {
    const auto a = static_cast<std::size_t>(axis);
    const Axis& info = axes_[a];
    const std::int64_t low = cells.low[a], high = cells.high[a];
    if (info.repeat && floor_divide(low, info.texels) != floor_divide(high - 1, info.texels)) {
        const std::int64_t period = floor_divide(low + (high - low) / 2, info.texels) * info.texels;
        return period > low ? period : period + info.texels;
    }
    const std::int64_t first = info.local(low), last = info.local(high - 1);
    const int bit = differing_bits(first, last) - 1;
    return low + ((last >> bit) << bit) - first;
}

CellCounts CellRanges::counts(const Cells& single) const {
    const std::int64_t x0 = axes_[0].texel(single.low[0]), x1 = axes_[0].texel(single.low[0] + 1);
    const std::int64_t y0 = axes_[1].texel(single.low[1]), y1 = axes_[1].texel(single.low[1] + 1);
    return cell_counts(single, at(x0, y0), at(x1, y0), at(x0, y1), at(x1, y1));
}

}  // namespace relievo::reference
