#include "editor/session/surface/owned_texels.h"

#include <algorithm>

#include "editor/session/surface/texel_triangle.h"

namespace relievo {

void OwnedTexels::fill(std::size_t first, std::size_t last) {
    const std::uint64_t head = ~std::uint64_t{0} << (first & 63),
                        tail = ~std::uint64_t{0} >> (63 - (last & 63));
    if (first >> 6 == last >> 6) {
        words_[first >> 6] |= head & tail;
        return;
    }
    words_[first >> 6] |= head;
    for (std::size_t w = (first >> 6) + 1; w < last >> 6; ++w) words_[w] = ~std::uint64_t{0};
    words_[last >> 6] |= tail;
}

OwnedTexels::OwnedTexels(const Mesh& mesh, const MapGrid& grid)
    : words_((static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height) + 63) / 64) {
    const std::int64_t width = grid.width;
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        const TexelTriangle triangle = texel_triangle(mesh, face, grid);
        if (!can_rasterise(triangle, grid)) continue;
        const TexelSpan rows = clipped(triangle.rows(), grid.height, grid.wrap);
        for (std::int64_t y = rows.first; y <= rows.last; ++y) {
            const TexelSpan span = clipped(triangle.columns(y), grid.width, grid.wrap);
            if (span.first > span.last) continue;
            const auto row = static_cast<std::size_t>(MapGrid::wrapped(y, grid.height) * width);
            const std::int64_t count = std::min(span.last - span.first + 1, width);
            const std::int64_t begin = MapGrid::wrapped(span.first, width);
            const std::int64_t end = std::min(begin + count, width);
            fill(row + static_cast<std::size_t>(begin), row + static_cast<std::size_t>(end) - 1);
            if (begin + count > width) fill(row, row + static_cast<std::size_t>(begin + count - width) - 1);
        }
    }
}

}  // namespace relievo
