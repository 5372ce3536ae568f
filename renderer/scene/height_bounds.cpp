// Height ranges of triangles by a min-max pyramid. A node is opened only when it could widen the range found
// so far, so the texels along a large triangle's border are rarely read.
#include <algorithm>

#include "renderer/scene/triangle_bounds.h"

namespace relievo {

namespace {

void include(HeightRange& range, const HeightRange& other) {
    range.low = std::min(range.low, other.low);
    range.high = std::max(range.high, other.high);
}

// Signed 16-bit minima and maxima are what every x86-64 has instructions for; unsigned ones are not.
HeightRange range_of(const std::uint16_t* texels, int count, HeightRange range) {
    const auto flip = [](std::uint16_t value) { return static_cast<std::int16_t>(value ^ 0x8000); };
    std::int16_t low = flip(range.low), high = flip(range.high);
    for (int i = 0; i < count; ++i) {
        const std::int16_t value = flip(texels[i]);
        low = value < low ? value : low;
        high = value > high ? value : high;
    }
    return {static_cast<std::uint16_t>(low ^ 0x8000), static_cast<std::uint16_t>(high ^ 0x8000)};
}

int divide_up(int value, int by) {
    return (value + by - 1) / by;
}

}  // namespace

HeightBounds::HeightBounds(int width, int height, const std::uint16_t* texels, Wrap wrap)
    : width_(width), height_(height), texels_(texels), wrap_(wrap) {
    int x = divide_up(width, kBlock), y = divide_up(height, kBlock);
    for (;; x = divide_up(x, 2), y = divide_up(y, 2)) {
        levels_.push_back(
            {x, y, std::vector<HeightRange>(static_cast<std::size_t>(x) * static_cast<std::size_t>(y))});
        if (x == 1 && y == 1) break;
    }
    update({0, 0, width, height});
}

void HeightBounds::update(const TexelBox& rect) {
    TexelBox nodes{std::max(rect.x0, 0), std::max(rect.y0, 0), std::min(rect.x1, width_),
                   std::min(rect.y1, height_)};
    if (nodes.x0 >= nodes.x1 || nodes.y0 >= nodes.y1) return;
    nodes = {nodes.x0 / kBlock, nodes.y0 / kBlock, divide_up(nodes.x1, kBlock), divide_up(nodes.y1, kBlock)};
    read_blocks(nodes);
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        nodes = {nodes.x0 / 2, nodes.y0 / 2, divide_up(nodes.x1, 2), divide_up(nodes.y1, 2)};
        reduce(level, nodes);
    }
}

void HeightBounds::read_blocks(const TexelBox& blocks) {
    Level& level = levels_[0];
    for (int y = blocks.y0; y < blocks.y1; ++y) {
        HeightRange* nodes = level.nodes.data() + static_cast<std::ptrdiff_t>(y) * level.width;
        std::fill(nodes + blocks.x0, nodes + blocks.x1, HeightRange{});
        const int end = std::min((y + 1) * kBlock, height_);
        for (int row = y * kBlock; row < end; ++row) {
            const std::uint16_t* texels = texels_ + static_cast<std::ptrdiff_t>(row) * width_;
            for (int x = blocks.x0; x < blocks.x1; ++x) {
                const int count = std::min(kBlock, width_ - x * kBlock);
                nodes[x] = count == kBlock ? range_of(texels + x * kBlock, kBlock, nodes[x])
                                           : range_of(texels + x * kBlock, count, nodes[x]);
            }
        }
    }
}

void HeightBounds::reduce(std::size_t level, const TexelBox& nodes) {
    const Level& below = levels_[level - 1];
    Level& here = levels_[level];
    for (int y = nodes.y0; y < nodes.y1; ++y) {
        for (int x = nodes.x0; x < nodes.x1; ++x) {
            HeightRange range;
            for (int v = 2 * y; v < std::min(2 * y + 2, below.height); ++v) {
                for (int u = 2 * x; u < std::min(2 * x + 2, below.width); ++u) {
                    include(range, below.nodes[static_cast<std::size_t>(v * below.width + u)]);
                }
            }
            here.nodes[static_cast<std::size_t>(y * here.width + x)] = range;
        }
    }
}

TexelBox HeightBounds::node_box(int level, int x, int y) const {
    const int side = kBlock << level;
    return {x * side, y * side, std::min((x + 1) * side, width_), std::min((y + 1) * side, height_)};
}

void HeightBounds::extend(const FootprintPiece& piece, int level, int x, int y, HeightRange& range) const {
    const Level& here = levels_[static_cast<std::size_t>(level)];
    const HeightRange node = here.nodes[static_cast<std::size_t>(y * here.width + x)];
    if (node.low >= range.low && node.high <= range.high) return;
    const TexelBox box = node_box(level, x, y);
    const Cover cover = piece.cover(box);
    if (cover == Cover::none) return;
    if (cover == Cover::all) return include(range, node);
    if (level == 0) return extend_by_rows(piece, box, range);
    const Level& below = levels_[static_cast<std::size_t>(level - 1)];
    for (int v = 2 * y; v < std::min(2 * y + 2, below.height); ++v) {
        for (int u = 2 * x; u < std::min(2 * x + 2, below.width); ++u) extend(piece, level - 1, u, v, range);
    }
}

void HeightBounds::extend_by_rows(const FootprintPiece& piece, const TexelBox& box,
                                  HeightRange& range) const {
    for (int y = std::max(box.y0, piece.box.y0); y < std::min(box.y1, piece.box.y1); ++y) {
        int first, last;
        piece.row(y, first, last);
        first = std::max(first, box.x0);
        last = std::min(last, box.x1);
        if (first < last)
            range = range_of(texels_ + static_cast<std::ptrdiff_t>(y) * width_ + first, last - first, range);
    }
}

HeightRange HeightBounds::range(const glm::vec2& uv0, const glm::vec2& uv1, const glm::vec2& uv2) const {
    std::array<FootprintPiece, kMostFootprintPieces> pieces;
    const std::size_t count = footprint_pieces({uv0, uv1, uv2}, width_, height_, wrap_, pieces);
    HeightRange range;
    for (std::size_t i = 0; i < count; ++i) {
        extend(pieces[i], static_cast<int>(levels_.size()) - 1, 0, 0, range);
    }
    return range;
}

HeightRange HeightBounds::range(const Mesh& mesh, std::uint32_t face) const {
    const auto& uv = mesh.faces[face].uv;
    return range(mesh.uvs[uv[0]], mesh.uvs[uv[1]], mesh.uvs[uv[2]]);
}

}  // namespace relievo
