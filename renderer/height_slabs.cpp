// See height_slabs.h. A node is bounded from what lies kPartLevels below it: up to level kPartLevels the texels
// themselves, above that nodes of the min-max pyramid, whose own width adds an eighth to what is told.
#include "renderer/height_slabs.h"

#include <algorithm>
#include <array>

namespace relievo {
namespace {

constexpr int kPartLevels = 3;
constexpr int kMostParts = 32;  // along one axis: of two nodes, the last of which is up to twice as wide, and a texel

// What a node is made of along one axis: texels, or nodes without overlap.
struct Parts {
    int count = 0;
    bool in_a_row = true;                  // `at` counts up by one
    std::array<int, kMostParts> at;        // the part's index in the map or in its level
    std::array<int, kMostParts> from, to;  // texels it reaches over, from the node's middle; not wrapped
    void add(int index, int first, int last) {
        in_a_row = in_a_row && (count == 0 || at[static_cast<std::size_t>(count - 1)] + 1 == index);
        const auto k = static_cast<std::size_t>(count++);
        at[k] = index, from[k] = first, to[k] = last;
    }
};

struct AxisOfNode {
    int size;   // of the map
    int nodes;  // of the level
    int node;
    bool repeat;
};

// A stretch over the level's only node may go around the map, and one at a clamped border beyond it.
bool may_tilt(const AxisOfNode& axis) {
    return axis.nodes > 1 && (axis.repeat || (axis.node > 0 && axis.node + 1 < axis.nodes));
}

int texel_index(const AxisOfNode& axis, int texel) {
    if (!axis.repeat) return std::min(texel, axis.size - 1);
    while (texel >= axis.size) texel -= axis.size;  // seldom; a division costs more
    return texel;
}

Parts parts_of(const AxisOfNode& axis, int level) {
    const int part_level = std::max(level - kPartLevels, 0), middle = (axis.node + 1) << level;
    const int parts_of_map = std::max(axis.size >> part_level, 1);
    Parts parts;
    for (int k = 0; k < 2; ++k) {
        const bool around = axis.node + k >= axis.nodes;
        if (around && !axis.repeat) break;
        const int node = around ? 0 : axis.node + k, start = around ? axis.size - middle : -middle;
        const int per_node = 1 << (level - part_level);
        const int end = node + 1 == axis.nodes ? parts_of_map : (node + 1) * per_node;
        for (int i = node * per_node; i < end; ++i) {
            const int texel = start + (i << part_level);
            const int after = i + 1 == parts_of_map ? start + axis.size : start + ((i + 1) << part_level);
            parts.add(i, texel, part_level == 0 ? texel : after);
        }
    }
    if (part_level == 0) {  // cells end at the texel after
        const int last = parts.to[static_cast<std::size_t>(parts.count - 1)] + 1;
        parts.add(texel_index(axis, last + middle), last, last);
    }
    return parts;
}

// Least and greatest height over the plane, times 2^level. Most are found in floats, which hold whole numbers up to
// 2^24: every x86-64 has instructions for their minima and maxima, not for integers'.
struct WholeSpan {
    int low, high;
};

WholeSpan over_texels(const HeightView& map, int level, const Parts& columns, const Parts& rows, int rise_x, int rise_y) {
    std::array<int, kMostParts> across;
    for (std::size_t k = 0; k < static_cast<std::size_t>(columns.count); ++k) across[k] = rise_x * columns.from[k];
    std::array<std::uint16_t, kMostParts> gathered;
    WholeSpan span{1 << 30, -(1 << 30)};
    for (std::size_t r = 0; r < static_cast<std::size_t>(rows.count); ++r) {
        const std::uint16_t* row = map.texels + static_cast<std::size_t>(rows.at[r]) * static_cast<std::size_t>(map.width);
        if (columns.in_a_row) {
            row += columns.at[0];
        } else {
            for (std::size_t k = 0; k < static_cast<std::size_t>(columns.count); ++k)
                gathered[k] = row[columns.at[k]];
            row = gathered.data();
        }
        int low = 1 << 30, high = -(1 << 30);
        for (int k = 0; k < columns.count; ++k) {
            const int over = (static_cast<int>(row[k]) << level) - across[static_cast<std::size_t>(k)];
            low = std::min(low, over);
            high = std::max(high, over);
        }
        const int up = rise_y * rows.from[r];
        span.low = std::min(span.low, low - up);
        span.high = std::max(span.high, high - up);
    }
    return span;
}

// The same of a node inside the map, where all of an edit's lie but few: 2^(level + 1) + 1 texels a side, in a row.
template <int kLevel>
WholeSpan over_square(const std::uint16_t* row, std::size_t stride, int rise_x, int rise_y) {
    constexpr int kHalf = 1 << kLevel, kSide = 2 * kHalf + 1;
    std::array<float, kSide> low, high, across;
    low.fill(1e9f);
    high.fill(-1e9f);
    for (int k = 0; k < kSide; ++k) across[static_cast<std::size_t>(k)] = static_cast<float>(rise_x * (k - kHalf));
    for (int r = -kHalf; r <= kHalf; ++r, row += stride) {
        const auto up = static_cast<float>(rise_y * r);
        const auto include = [&](std::size_t k) {
            const float over = static_cast<float>(row[k] * kHalf) - across[k] - up;
            low[k] = over < low[k] ? over : low[k];
            high[k] = over > high[k] ? over : high[k];
        };
        for (std::size_t k = 0; k < kSide - 1; ++k) include(k);  // whole vectors
        include(kSide - 1);
    }
    return {static_cast<int>(*std::min_element(low.begin(), low.end())),
            static_cast<int>(*std::max_element(high.begin(), high.end()))};
}

// The same of nodes, which hold their heights anywhere over their texels.
WholeSpan over_nodes(const HeightPyramid& pyramid, int level, const Parts& columns, const Parts& rows, int rise_x, int rise_y) {
    const auto count = static_cast<std::size_t>(columns.count);
    std::array<float, kMostParts> least, greatest, low, high;  // of the plane over each column; then of heights over it
    for (std::size_t k = 0; k < count; ++k) {
        const auto a = static_cast<float>(rise_x * columns.from[k]), b = static_cast<float>(rise_x * columns.to[k]);
        least[k] = std::min(a, b), greatest[k] = std::max(a, b);
        low[k] = 1e9f, high[k] = -1e9f;
    }
    std::array<HeightPyramid::Node, kMostParts> gathered;
    for (std::size_t r = 0; r < static_cast<std::size_t>(rows.count); ++r) {
        const HeightPyramid::Node* row = &pyramid.plain(level - kPartLevels, columns.at[0], rows.at[r]);
        if (!columns.in_a_row) {
            for (std::size_t k = 0; k < count; ++k)
                gathered[k] = pyramid.plain(level - kPartLevels, columns.at[k], rows.at[r]);
            row = gathered.data();
        }
        const auto a = static_cast<float>(rise_y * rows.from[r]), b = static_cast<float>(rise_y * rows.to[r]);
        const float up = std::max(a, b), down = std::min(a, b);
        for (std::size_t k = 0; k < count; ++k) {
            const float l = static_cast<float>(row[k].low << level) - greatest[k] - up;
            const float h = static_cast<float>(row[k].high << level) - least[k] - down;
            low[k] = l < low[k] ? l : low[k];
            high[k] = h > high[k] ? h : high[k];
        }
    }
    const auto end = static_cast<std::ptrdiff_t>(count);
    constexpr int kDifferencesRounding = 2;  // of two differences below 2^25
    return {static_cast<int>(*std::min_element(low.begin(), low.begin() + end)) - kDifferencesRounding,
            static_cast<int>(*std::max_element(high.begin(), high.begin() + end)) + kDifferencesRounding};
}

WholeSpan span_over_plane(const HeightView& map, const HeightPyramid& pyramid, int level, const AxisOfNode& x,
                     const AxisOfNode& y, int rise_x, int rise_y) {
    if (level <= kPartLevels && x.node + 2 < x.nodes && y.node + 2 < y.nodes) {
        const auto stride = static_cast<std::size_t>(map.width);
        const std::uint16_t* corner = map.texels + static_cast<std::size_t>(y.node << level) * stride + (x.node << level);
        switch (level) {
            case 1: return over_square<1>(corner, stride, rise_x, rise_y);
            case 2: return over_square<2>(corner, stride, rise_x, rise_y);
            default: return over_square<kPartLevels>(corner, stride, rise_x, rise_y);
        }
    }
    const Parts columns = parts_of(x, level), rows = parts_of(y, level);
    return level <= kPartLevels ? over_texels(map, level, columns, rows, rise_x, rise_y)
                                : over_nodes(pyramid, level, columns, rows, rise_x, rise_y);
}

std::int16_t packed(int height) {
    return static_cast<std::int16_t>(height - 32768);
}

}  // namespace

PackedSlab height_slab(const HeightView& map, const HeightPyramid& pyramid, int level, int i, int j) {
    const HeightPyramid::Node bounds = pyramid.overlapping(level, i, j);
    const PackedSlab flat{packed(bounds.low), packed(bounds.high), 0, 0};
    const bool repeat = pyramid.wrap() == Wrap::repeat;
    const AxisOfNode x{map.width, pyramid.width(level), i, repeat}, y{map.height, pyramid.height(level), j, repeat};
    const int range = bounds.high - bounds.low;
    if (range < 4 || (!may_tilt(x) && !may_tilt(y))) return flat;

    const int u0 = texel_index(x, i << level), u1 = texel_index(x, (i + 2) << level);
    const int v0 = texel_index(y, j << level), v1 = texel_index(y, (j + 2) << level);
    const auto at = [&](int u, int v) {
        return static_cast<int>(map.texels[static_cast<std::size_t>(v) * static_cast<std::size_t>(map.width) +
                                           static_cast<std::size_t>(u)]);
    };
    const int h00 = at(u0, v0), h10 = at(u1, v0), h01 = at(u0, v1), h11 = at(u1, v1);
    const int rise_x = may_tilt(x) ? (h10 - h00 + h11 - h01) / 4 : 0;
    const int rise_y = may_tilt(y) ? (h01 - h00 + h11 - h10) / 4 : 0;
    const WholeSpan over = span_over_plane(map, pyramid, level, x, y, rise_x, rise_y);
    const int low = over.low >> level, high = -(-over.high >> level);  // outward
    if (low < 0 || high > 65535 || 4 * (high - low) > 3 * range) return flat;
    return {packed(low), packed(high), static_cast<std::int16_t>(rise_x), static_cast<std::int16_t>(rise_y)};
}

}  // namespace relievo
