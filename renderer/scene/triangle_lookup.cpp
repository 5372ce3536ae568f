// Triangles by the texels they touch: a uniform grid in texel space, filled by counting.
#include <algorithm>
#include <cmath>

#include "renderer/scene/triangle_bounds.h"

namespace relievo {

namespace {

// About one cell a triangle, and no more than this many a side.
constexpr double kMostCellsASide = 256;

}  // namespace

TriangleLookup::TriangleLookup(const Mesh& mesh, int width, int height, Wrap wrap)
    : width_(width), height_(height) {
    const double faces = static_cast<double>(std::max<std::size_t>(mesh.faces.size(), 1));
    const double texels = static_cast<double>(width) * static_cast<double>(height);
    const double longer = std::max(width, height);
    cell_size_ =
        static_cast<int>(std::ceil(std::max({std::sqrt(texels / faces), longer / kMostCellsASide, 1.0})));
    cells_x_ = (width + cell_size_ - 1) / cell_size_;
    cells_y_ = (height + cell_size_ - 1) / cell_size_;

    std::array<FootprintPiece, kMostFootprintPieces> areas;
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        const auto& uv = mesh.faces[face].uv;
        const std::size_t count =
            footprint_pieces({mesh.uvs[uv[0]], mesh.uvs[uv[1]], mesh.uvs[uv[2]]}, width, height, wrap, areas);
        for (std::size_t i = 0; i < count; ++i) pieces_.push_back({areas[i], face});
    }
    insert_pieces();
}

void TriangleLookup::insert_pieces() {
    const auto each_cell = [this](const FootprintPiece& area, auto&& visit) {
        const TexelBox& box = area.box;
        for (int y = box.y0 / cell_size_; y <= (box.y1 - 1) / cell_size_; ++y) {
            for (int x = box.x0 / cell_size_; x <= (box.x1 - 1) / cell_size_; ++x) {
                const TexelBox cell{x * cell_size_, y * cell_size_, std::min((x + 1) * cell_size_, width_),
                                    std::min((y + 1) * cell_size_, height_)};
                if (area.cover(cell) != Cover::none) visit(static_cast<std::size_t>(y * cells_x_ + x));
            }
        }
    };
    const auto cells = static_cast<std::size_t>(cells_x_) * static_cast<std::size_t>(cells_y_);
    cell_begin_.assign(cells + 1, 0);
    for (const Piece& piece : pieces_)
        each_cell(piece.area, [&](std::size_t cell) { ++cell_begin_[cell + 1]; });
    for (std::size_t cell = 0; cell < cells; ++cell) cell_begin_[cell + 1] += cell_begin_[cell];
    cell_pieces_.resize(cell_begin_[cells]);
    std::vector<std::uint32_t> next(cell_begin_.begin(), cell_begin_.end() - 1);
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
        each_cell(pieces_[i].area, [&](std::size_t cell) { cell_pieces_[next[cell]++] = i; });
    }
}

void TriangleLookup::find(const TexelBox& rect, std::vector<std::uint32_t>& faces) const {
    faces.clear();
    const TexelBox box{std::max(rect.x0, 0), std::max(rect.y0, 0), std::min(rect.x1, width_),
                       std::min(rect.y1, height_)};
    if (box.x0 >= box.x1 || box.y0 >= box.y1) return;
    for (int y = box.y0 / cell_size_; y <= (box.y1 - 1) / cell_size_; ++y) {
        for (int x = box.x0 / cell_size_; x <= (box.x1 - 1) / cell_size_; ++x) {
            const auto cell = static_cast<std::size_t>(y * cells_x_ + x);
            for (std::uint32_t i = cell_begin_[cell]; i < cell_begin_[cell + 1]; ++i) {
                const Piece& piece = pieces_[cell_pieces_[i]];
                if (piece.area.cover(box) != Cover::none) faces.push_back(piece.face);
            }
        }
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

}  // namespace relievo
