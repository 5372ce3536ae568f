// Min-max pyramid of a displacement map for methods that bound heights, over the cells between texel centres.
//
// As quadtree displacement mapping has it (Drobot 2009), with overlap (ours): node (i, j) of level l holds the least
// and the greatest texel that bilinear filtering can touch over the cells [i 2^l, (i + 2) 2^l) and the like in j, so
// that one fetch bounds any stretch of 2^l cells that begins in node (i, j). Levels run from 1; level l has
// max(1, size >> l) nodes a side, the last one takes what is left over. Repeat wraps around, clamp ends at the border.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/beside.h"
#include "renderer/renderer.h"
#include "shaders/shared.h"

namespace relievo {

class HeightPyramid {
  public:
    struct Node {
        std::uint16_t low = 65535, high = 0;
    };
    struct Nodes {  // half-open, of one level
        int level, x0, y0, x1, y1;
    };

    HeightPyramid(const HeightView& map, Wrap wrap, const WorkPart& part = {});

    int levels() const { return static_cast<int>(plain_.size()); }  // at most gpu::kPyramidLevels
    int width(int level) const { return plain_[index(level)].width; }
    int height(int level) const { return plain_[index(level)].height; }

    // Reduces again what the texels of the rectangle reach, at the cost of the rectangle, and returns the overlapping
    // nodes that may have changed: equal to a full rebuild.
    std::vector<Nodes> update(const HeightView& map, const TexelRegion& region);

    Wrap wrap() const { return wrap_; }
    Node overlapping(int level, int x, int y) const;
    // Over the node's own cells alone: [x 2^level, (x + 1) 2^level), and what is left over in the last one.
    const Node& plain(int level, int x, int y) const;

  private:
    struct Level {
        int width, height;
        std::vector<Node> nodes;
    };
    struct Span {  // nodes first..last along one axis, first may be below 0 under repeat
        int first, last;
    };
    static std::size_t index(int level) { return static_cast<std::size_t>(level - 1); }
    Node& plain(int level, int x, int y);
    Node reduce(const HeightView& map, int level, int x, int y) const {
        return level == 1 ? reduce_texels(map, x, y) : reduce_nodes(level, x, y);
    }
    Node reduce_texels(const HeightView& map, int x, int y) const;
    Node reduce_nodes(int level, int x, int y) const;
    std::vector<Span> split(Span span, int size) const;

    Wrap wrap_;
    std::vector<Level> plain_;  // without overlap
};

}  // namespace relievo
