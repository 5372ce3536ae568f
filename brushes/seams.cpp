// Copies, extension and least squares along texture seams; see the header for the paper and what we changed.
#include "brushes/seams.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace relievo {
namespace {

// Damping against unit residuals. An equation's weights are about 1 in sum on each side and come at least
// twice a texel, so 0.01 leaves about 1% of a difference between the sides; much less would bend the border's
// texels to cancel the kinks that the two grids cannot share.
constexpr double kOwnedDamping = 1e-2;
constexpr double kLooseDamping = 1e-3;

template <typename Index, typename Visit>
void visit_tile(const Index& index, std::uint32_t tile, Visit&& visit) {
    for (auto it = std::lower_bound(index.begin(), index.end(), std::pair{tile, std::uint32_t{0}});
         it != index.end() && it->first == tile; ++it)
        visit(it->second);
}

template <typename Index>
void sort_unique(Index& index) {
    std::sort(index.begin(), index.end());
    index.erase(std::unique(index.begin(), index.end()), index.end());
}

bool contains(const TexelRect& rect, int x, int y) {
    return x >= rect.x0 && x < rect.x1 && y >= rect.y0 && y < rect.y1;
}

// The equations' rows over the unknowns, and what the present values leave of them.
struct System {
    Eigen::SparseMatrix<double> rows;
    Eigen::VectorXd residual;
};

System assemble(const std::vector<SeamEquation>& equations, const std::vector<std::uint32_t>& chosen,
                const std::vector<std::uint32_t>& unknowns, const std::vector<double>& values) {
    System system;
    system.residual = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(chosen.size()));
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const SeamEquation& equation = equations[chosen[i]];
        for (int k = 0; k < 8; ++k) {
            const double weight = double{equation.weight[k]};
            system.residual[static_cast<Eigen::Index>(i)] -=
                weight * values[8 * i + static_cast<std::size_t>(k)];
            const auto found = std::lower_bound(unknowns.begin(), unknowns.end(), equation.texel[k]);
            if (weight != 0.0 && found != unknowns.end() && *found == equation.texel[k])
                entries.emplace_back(static_cast<int>(i), static_cast<int>(found - unknowns.begin()), weight);
        }
    }
    system.rows.resize(static_cast<Eigen::Index>(chosen.size()), static_cast<Eigen::Index>(unknowns.size()));
    system.rows.setFromTriplets(entries.begin(), entries.end());  // adds up a texel that both sides read
    return system;
}

}  // namespace

Seams::Seams(const Surface& surface, int width, int height)
    : width_(static_cast<std::uint32_t>(width)), height_(static_cast<std::uint32_t>(height)) {
    const SeamTable& table = surface.seams();
    const TileGrid grid(width, height);
    index_copies(table, grid);
    index_equations(table, surface, grid);
}

void Seams::index_copies(const SeamTable& table, const TileGrid& grid) {
    copies_ = table.copies;
    std::sort(copies_.begin(), copies_.end(),
              [](const SeamCopy& a, const SeamCopy& b) { return a.gutter < b.gutter; });
    for (std::uint32_t i = 0; i < copies_.size(); ++i) {
        if (std::max(copies_[i].gutter, copies_[i].source) >= width_ * height_)
            throw std::invalid_argument("seam copy " + std::to_string(i) + " lies outside the map");
        copies_of_tile_.emplace_back(grid.tile_of(copies_[i].source), i);
        copies_of_tile_.emplace_back(grid.tile_of(copies_[i].gutter), i);
    }
    sort_unique(copies_of_tile_);
}

void Seams::index_equations(const SeamTable& table, const Surface& surface, const TileGrid& grid) {
    const auto resolved = [&](std::uint32_t texel) {
        const auto found =
            std::lower_bound(copies_.begin(), copies_.end(), texel,
                             [](const SeamCopy& copy, std::uint32_t t) { return copy.gutter < t; });
        return found != copies_.end() && found->gutter == texel ? found->source : texel;
    };
    equations_ = table.equations;
    std::vector<std::uint32_t> loose;
    for (std::uint32_t i = 0; i < equations_.size(); ++i) {
        for (int k = 0; k < 8; ++k) {
            std::uint32_t& texel = equations_[i].texel[k];
            if (texel >= width_ * height_)
                throw std::invalid_argument("seam equation " + std::to_string(i) + " lies outside the map");
            if (equations_[i].weight[k] == 0.0f) continue;
            texel = resolved(texel);
            equations_of_tile_.emplace_back(grid.tile_of(texel), i);
            if (const Texel at = place(texel); !surface.owned(at.x, at.y)) loose.push_back(texel);
        }
    }
    sort_unique(equations_of_tile_);
    sort_unique(loose);
    for (const std::uint32_t texel : loose) add_loose(texel, surface, grid);
    sort_unique(loose_of_tile_);
}

void Seams::add_loose(std::uint32_t texel, const Surface& surface, const TileGrid& grid) {
    Loose loose{texel, {}};
    const Texel at = place(texel);
    for (int y = std::max(at.y - 1, 0); y <= std::min<int>(at.y + 1, static_cast<int>(height_) - 1); ++y)
        for (int x = std::max(at.x - 1, 0); x <= std::min<int>(at.x + 1, static_cast<int>(width_) - 1); ++x) {
            if (!surface.owned(x, y)) continue;
            loose.neighbours.push_back({static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)});
            loose_of_tile_.emplace_back(grid.tile_of(x, y), static_cast<std::uint32_t>(loose_.size()));
        }
    loose_.push_back(std::move(loose));
}

bool Seams::is_gutter(int x, int y) const {
    const std::uint32_t texel = static_cast<std::uint32_t>(y) * width_ + static_cast<std::uint32_t>(x);
    const auto found =
        std::lower_bound(copies_.begin(), copies_.end(), texel,
                         [](const SeamCopy& copy, std::uint32_t t) { return copy.gutter < t; });
    return found != copies_.end() && found->gutter == texel;
}

bool Seams::is_loose(std::uint32_t texel) const {
    const auto found = std::lower_bound(loose_.begin(), loose_.end(), texel,
                                        [](const Loose& loose, std::uint32_t t) { return loose.texel < t; });
    return found != loose_.end() && found->texel == texel;
}

void Seams::follow(StrokeTiles& stroke) const {
    extend_islands(stroke);
    copy_changed(stroke);
}

void Seams::copy_changed(StrokeTiles& stroke) const {
    const std::vector<std::uint32_t> tiles = stroke.dirty();  // copies may add to it
    for (const std::uint32_t tile : tiles) {
        const TexelRect dirty = stroke.tile(tile)->dirty;
        visit_tile(copies_of_tile_, tile, [&](std::uint32_t i) {
            const Texel from = place(copies_[i].source), to = place(copies_[i].gutter);
            if (contains(dirty, from.x, from.y) || contains(dirty, to.x, to.y))
                stroke.copy(from.x, from.y, to.x, to.y);
        });
    }
}

void Seams::extend_islands(StrokeTiles& stroke) const {
    std::vector<std::uint32_t> changed;
    for (const std::uint32_t tile : stroke.dirty()) {
        const TexelRect dirty = stroke.tile(tile)->dirty;
        visit_tile(loose_of_tile_, tile, [&](std::uint32_t i) {
            const auto& around = loose_[i].neighbours;
            if (std::any_of(around.begin(), around.end(), [&](Texel t) { return contains(dirty, t.x, t.y); }))
                changed.push_back(i);
        });
    }
    sort_unique(changed);
    for (const std::uint32_t i : changed) {
        float sum = 0.0f;
        for (const Texel t : loose_[i].neighbours) sum += stroke.value(t.x, t.y);
        const Texel at = place(loose_[i].texel);
        stroke.set_value(at.x, at.y, sum / static_cast<float>(loose_[i].neighbours.size()));
    }
}

std::vector<std::uint32_t> Seams::touched_texels(const StrokeTiles& stroke) const {
    std::vector<std::uint32_t> texels, seen;
    for (const std::uint32_t tile : stroke.touched())
        visit_tile(equations_of_tile_, tile, [&](std::uint32_t i) { seen.push_back(i); });
    sort_unique(seen);
    for (const std::uint32_t i : seen) {
        const SeamEquation& equation = equations_[i];
        bool touched = false;
        for (int k = 0; k < 8 && !touched; ++k) {
            const Texel at = place(equation.texel[k]);
            touched = equation.weight[k] != 0.0f && std::abs(stroke.change(at.x, at.y)) >= 0.5f;
        }
        for (int k = 0; k < 8 && touched; ++k)
            if (equation.weight[k] != 0.0f) texels.push_back(equation.texel[k]);
    }
    sort_unique(texels);
    return texels;
}

std::vector<std::uint32_t> Seams::equations_on(const std::vector<std::uint32_t>& texels,
                                               const TileGrid& grid) const {
    std::vector<std::uint32_t> tiles, chosen;
    for (const std::uint32_t texel : texels) tiles.push_back(grid.tile_of(texel));
    sort_unique(tiles);
    for (const std::uint32_t tile : tiles)
        visit_tile(equations_of_tile_, tile, [&](std::uint32_t i) {
            for (int k = 0; k < 8; ++k)
                if (std::binary_search(texels.begin(), texels.end(), equations_[i].texel[k]))
                    chosen.push_back(i);
        });
    sort_unique(chosen);
    return chosen;
}

void Seams::settle(StrokeTiles& stroke) const {
    const std::vector<std::uint32_t> unknowns = touched_texels(stroke);
    if (unknowns.empty()) return;
    const std::vector<std::uint32_t> chosen = equations_on(unknowns, stroke.grid());
    std::vector<double> values;
    values.reserve(8 * chosen.size());
    for (const std::uint32_t i : chosen)
        for (const std::uint32_t texel : equations_[i].texel)
            values.push_back(double{stroke.value(place(texel).x, place(texel).y)});
    const System system = assemble(equations_, chosen, unknowns, values);

    Eigen::SparseMatrix<double> normal = system.rows.transpose() * system.rows;
    for (std::size_t i = 0; i < unknowns.size(); ++i)
        normal.coeffRef(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) +=
            is_loose(unknowns[i]) ? kLooseDamping : kOwnedDamping;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factored(normal);
    const Eigen::VectorXd step = factored.solve(system.rows.transpose() * system.residual);
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const Texel at = place(unknowns[i]);
        const float change =
            stroke.change(at.x, at.y) + static_cast<float>(step[static_cast<Eigen::Index>(i)]);
        stroke.set_change(at.x, at.y, change);
    }
    copy_changed(stroke);
}

}  // namespace relievo
