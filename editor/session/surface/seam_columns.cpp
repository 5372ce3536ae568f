#include "editor/session/surface/seam_columns.h"

#include <algorithm>
#include <cmath>

namespace relievo {

void for_each_column(const UvSeam& seam, const MapGrid& grid,
                     const std::function<void(const SeamColumn&)>& visit) {
    const TexelIsometry to_b = across(seam);
    const glm::length_t along = std::abs(seam.a.to.x - seam.a.from.x) < kTexelSlack ? 1 : 0;
    const double place = snapped(seam.a.from[1 - along]);
    const double low = snapped(std::min(seam.a.from[along], seam.a.to[along]));
    const double high = snapped(std::max(seam.a.from[along], seam.a.to[along]));
    const bool inside_above = seam.a.inner[1 - along] > place;

    const auto below = static_cast<std::int64_t>(std::floor(place));
    const double f = place - std::floor(place);
    // On texel centres one row alone is read: it is the inside and the outside of both islands.
    const std::int64_t above = f == 0 ? below : below + 1;
    const std::int64_t in = inside_above ? above : below, out = inside_above ? below : above;
    const double weight_in = f == 0 ? 0.5 : (inside_above ? f : 1 - f);
    for (auto i = static_cast<std::int64_t>(std::floor(low)); i <= static_cast<std::int64_t>(std::ceil(high));
         ++i) {
        const auto centre = static_cast<double>(i);
        const auto texel = [&](std::int64_t row, bool mapped) {
            const std::int64_t x = along == 0 ? i : row, y = along == 0 ? row : i;
            return mapped ? grid.index(to_b.x(x, y), to_b.y(x, y)) : grid.index(x, y);
        };
        visit({texel(in, false), texel(out, false), texel(out, true), texel(in, true), weight_in,
               1 - weight_in, centre < low + 1 || centre > high - 1, centre < low || centre > high});
    }
}

}  // namespace relievo
