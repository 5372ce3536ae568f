// A half-open rectangle of texels; the unit in which edits travel from the brushes to the renderer.
#pragma once

#include <algorithm>

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
    bool operator==(const TexelRect&) const = default;
};

}  // namespace relievo
