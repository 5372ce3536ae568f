// See height_pyramid.h.
#include "renderer/height_pyramid.h"

#include <algorithm>

namespace relievo {
namespace {

int wrapped(int i, int size, Wrap wrap) {
    if (wrap == Wrap::clamp) return std::clamp(i, 0, size - 1);
    const int r = i % size;
    return r < 0 ? r + size : r;
}

int floor_half(int i) { return i >= 0 ? i / 2 : -((1 - i) / 2); }

void include(HeightPyramid::Node& node, const HeightPyramid::Node& other) {
    node.low = std::min(node.low, other.low);
    node.high = std::max(node.high, other.high);
}

}  // namespace

HeightPyramid::HeightPyramid(const HeightView& map, Wrap wrap, const WorkPart& part) : wrap_(wrap) {
    for (int level = 1; level <= gpu::kPyramidLevels; ++level) {
        const int w = std::max(1, map.width >> level), h = std::max(1, map.height >> level);
        plain_.push_back({w, h, std::vector<Node>(static_cast<std::size_t>(w) * static_cast<std::size_t>(h))});
        if (w == 1 && h == 1) break;
    }
    double begin = 0;  // of the level; the finest of n is as much work as three quarters of them all
    for (int level = 1; level <= levels(); ++level) {
        const double share = 0.75 * (1 - begin);
        for (int y = 0; y < height(level); ++y) {
            part.at(begin + share * y / height(level));
            for (int x = 0; x < width(level); ++x) plain(level, x, y) = reduce(map, level, x, y);
        }
        begin += share;
    }
}

HeightPyramid::Node& HeightPyramid::plain(int level, int x, int y) {
    Level& l = plain_[index(level)];
    return l.nodes[static_cast<std::size_t>(y) * static_cast<std::size_t>(l.width) + static_cast<std::size_t>(x)];
}

const HeightPyramid::Node& HeightPyramid::plain(int level, int x, int y) const {
    const Level& l = plain_[index(level)];
    return l.nodes[static_cast<std::size_t>(y) * static_cast<std::size_t>(l.width) + static_cast<std::size_t>(x)];
}

// Level 1: cells 2x and 2x + 1 (the last node: all that are left), so texels up to one further.
HeightPyramid::Node HeightPyramid::reduce_texels(const HeightView& map, int x, int y) const {
    const int x1 = x + 1 == width(1) ? map.width : 2 * x + 2, y1 = y + 1 == height(1) ? map.height : 2 * y + 2;
    Node node;
    for (int v = 2 * y; v <= y1; ++v) {
        const std::uint16_t* row = map.texels + static_cast<std::size_t>(wrapped(v, map.height, wrap_)) *
                                                    static_cast<std::size_t>(map.width);
        for (int u = 2 * x; u < x1; ++u) {
            node.low = std::min(node.low, row[u]);
            node.high = std::max(node.high, row[u]);
        }
        const std::uint16_t border = row[wrapped(x1, map.width, wrap_)];
        node.low = std::min(node.low, border);
        node.high = std::max(node.high, border);
    }
    return node;
}

HeightPyramid::Node HeightPyramid::reduce_nodes(int level, int x, int y) const {
    const int below = level - 1;
    const int x1 = x + 1 == width(level) ? width(below) : 2 * x + 2;
    const int y1 = y + 1 == height(level) ? height(below) : 2 * y + 2;
    Node node;
    for (int v = 2 * y; v < y1; ++v)
        for (int u = 2 * x; u < x1; ++u) include(node, plain(below, u, v));
    return node;
}

HeightPyramid::Node HeightPyramid::overlapping(int level, int x, int y) const {
    const auto next = [&](int i, int size) { return i + 1 < size ? i + 1 : wrap_ == Wrap::clamp ? i : 0; };
    const int x1 = next(x, width(level)), y1 = next(y, height(level));
    Node node = plain(level, x, y);
    include(node, plain(level, x1, y));
    include(node, plain(level, x, y1));
    include(node, plain(level, x1, y1));
    return node;
}

// A span of nodes as half-open pieces inside [0, size): clipped under clamp, wrapped under repeat.
std::vector<HeightPyramid::Span> HeightPyramid::split(Span span, int size) const {
    span.first = std::min(span.first, size - 1);  // what lies beyond belongs to the last node
    span.last = std::min(span.last, size - 1);
    if (span.last - span.first + 1 >= size) return {{0, size}};
    if (span.first >= 0) return {{span.first, span.last + 1}};
    if (wrap_ == Wrap::clamp) return {{0, span.last + 1}};
    const int wrap_first = span.first + size;
    if (span.last < 0) return {{wrap_first, span.last + size + 1}};
    if (wrap_first <= span.last + 1) return {{0, size}};
    return {{0, span.last + 1}, {wrap_first, size}};
}

std::vector<HeightPyramid::Nodes> HeightPyramid::update(const HeightView& map, const TexelRegion& region) {
    std::vector<Nodes> changed;
    // Texel x belongs to the cells x - 1 and x. (Clamp repeats the border texel in cells of its own node.)
    Span across{region.x0 - 1, region.x1 - 1}, up{region.y0 - 1, region.y1 - 1};
    for (int level = 1; level <= levels(); ++level) {
        const int w = width(level), h = height(level);
        across = {floor_half(across.first), floor_half(across.last)};
        up = {floor_half(up.first), floor_half(up.last)};
        for (const Span& rows : split(up, h))
            for (const Span& columns : split(across, w))
                for (int y = rows.first; y < rows.last; ++y)
                    for (int x = columns.first; x < columns.last; ++x)
                        plain(level, x, y) = reduce(map, level, x, y);
        // Node i of the overlapping level also holds node i + 1. Within the last node's remainder, clip first.
        const Span over_x{std::min(across.first, w - 1) - 1, across.last}, over_y{std::min(up.first, h - 1) - 1, up.last};
        for (const Span& rows : split(over_y, h))
            for (const Span& columns : split(over_x, w))
                changed.push_back({level, columns.first, rows.first, columns.last, rows.last});
    }
    return changed;
}

}  // namespace relievo
