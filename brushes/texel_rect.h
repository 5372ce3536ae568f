// A half-open rectangle of texels; the unit in which edits travel from the brushes to the renderer.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace relievo {

struct TexelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // texels [x0, x1) x [y0, y1); row 0 is the lowest (v = 0)

    bool empty() const { return x0 >= x1 || y0 >= y1; }
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }

    void include(int x, int y) { include(TexelRect{x, y, x + 1, y + 1}); }
    void include(const TexelRect& r) {
        if (r.empty()) return;
        *this = empty() ? r
                        : TexelRect{std::min(x0, r.x0), std::min(y0, r.y0), std::max(x1, r.x1),
                                    std::max(y1, r.y1)};
    }
    bool contains(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
    bool overlaps(const TexelRect& r) const { return x0 < r.x1 && r.x0 < x1 && y0 < r.y1 && r.y0 < y1; }
    std::int64_t area() const { return empty() ? 0 : std::int64_t{width()} * height(); }
    bool operator==(const TexelRect&) const = default;
};

// Covers `rects` (none overlapping another) by at most `most` rectangles that do not overlap, merging
// neighbours where that adds little area, and anything only to keep within `most`. Sorted by (y0, x0); empty
// ones are dropped.
std::vector<TexelRect> merge_rects(std::vector<TexelRect> rects, std::size_t most = 64);

}  // namespace relievo
