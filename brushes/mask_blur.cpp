// Softening of a mask's borders, row by row.
#include "brushes/mask_blur.h"

#include <algorithm>
#include <vector>

#include "brushes/seams.h"
#include "brushes/surface.h"

namespace relievo {
namespace {

// Far from the mask's borders nothing changes: spares asking who owns texels there.
bool is_even(const HeightMap& mask, int x, int y) {
    const std::uint16_t own = mask.at(x, y);
    return (x == 0 || mask.at(x - 1, y) == own) && (x + 1 == mask.width() || mask.at(x + 1, y) == own) &&
           (y == 0 || mask.at(x, y - 1) == own) && (y + 1 == mask.height() || mask.at(x, y + 1) == own);
}

std::uint16_t blurred(const HeightMap& mask, const Surface& surface, const Seams& seams, int x, int y) {
    constexpr int kStep[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    const std::uint32_t own = mask.at(x, y);
    std::uint32_t sum = 0, count = 0;
    for (const auto& step : kStep) {
        const int i = x + step[0], j = y + step[1];
        if (i < 0 || j < 0 || i >= mask.width() || j >= mask.height()) continue;
        if (!surface.owned(i, j) && !seams.is_gutter(i, j)) continue;
        sum += mask.at(i, j), ++count;
    }
    return static_cast<std::uint16_t>(count == 0 ? own : (own + (sum + count / 2) / count + 1) / 2);
}

}  // namespace

void blur_once(HeightMap& mask, const Surface& surface, const Seams& seams) {
    const HeightMap before = mask;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            if (!is_even(before, x, y) && surface.owned(x, y))
                mask.set(x, y, blurred(before, surface, seams, x, y));
}

}  // namespace relievo
