// Copies, extension and least squares along texture seams; see the header for the paper and what we changed.
#include "brushes/seams.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "brushes/seam_solver.h"

namespace relievo {
Seams::Seams(const Surface& surface, int width, int height)
    : width_(static_cast<std::uint32_t>(width)),
      height_(static_cast<std::uint32_t>(height)),
      bends_(surface.seams(), width, height) {
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
        shifted_.push_back(bends_.determines(copies_[i].gutter));
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
            add_unowned_around(texel, surface, loose);
        }
    }
    sort_unique(equations_of_tile_);
    sort_unique(loose);
    for (const std::uint32_t texel : loose) add_loose(texel, surface, grid);
    sort_unique(loose_of_tile_);
}

// The texel and its neighbours where no triangle owns them: between the points of two equations, filtering
// may read the corner of a cell that neither names.
void Seams::add_unowned_around(std::uint32_t texel, const Surface& surface,
                               std::vector<std::uint32_t>& loose) const {
    const Texel at = place(texel);
    for (int y = at.y - 1; y <= at.y + 1; ++y)
        for (int x = at.x - 1; x <= at.x + 1; ++x) {
            const bool inside =
                x >= 0 && y >= 0 && x < static_cast<int>(width_) && y < static_cast<int>(height_);
            if (inside && !surface.owned(x, y) && !is_gutter(x, y))
                loose.push_back(static_cast<std::uint32_t>(y) * width_ + static_cast<std::uint32_t>(x));
        }
}

void Seams::add_loose(std::uint32_t texel, const Surface& surface, const TileGrid& grid) {
    Loose loose{texel, {}};
    const std::vector<SeamExtension>& extensions = surface.seams().extensions;
    const auto found =
        std::lower_bound(extensions.begin(), extensions.end(), texel,
                         [](const SeamExtension& extension, std::uint32_t t) { return extension.texel < t; });
    if (found != extensions.end() && found->texel == texel) {
        for (const SeamExtension::Source& source : found->sources) {
            if (source.texel >= width_ * height_)
                throw std::invalid_argument("seam extension of texel " + std::to_string(texel) +
                                            " lies outside the map");
            loose.sources.push_back({place(source.texel), source.weight});
        }
    } else {
        loose.sources = mean_of_owned(texel, surface, grid);
    }
    for (const Weighted& source : loose.sources)
        loose_of_tile_.emplace_back(grid.tile_of(source.at.x, source.at.y),
                                    static_cast<std::uint32_t>(loose_.size()));
    loose_.push_back(std::move(loose));
}

std::vector<Seams::Weighted> Seams::mean_of_owned(std::uint32_t texel, const Surface& surface,
                                                  const TileGrid& grid) const {
    std::vector<Weighted> sources;
    const Texel at = place(texel);
    const TexelRect map = grid.bounds();
    // A seam that clips the corner of a cell reads texels that are two away from any that a triangle owns.
    for (int reach = 1; reach <= 2 && sources.empty(); ++reach)
        for (int y = std::max(at.y - reach, 0); y < std::min(at.y + reach + 1, map.y1); ++y)
            for (int x = std::max(at.x - reach, 0); x < std::min(at.x + reach + 1, map.x1); ++x)
                if (surface.owned(x, y))
                    sources.push_back({{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)}, 1.0f});
    for (Weighted& source : sources) source.weight /= static_cast<float>(sources.size());
    return sources;
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

void Seams::follow(StrokeTiles& stroke, Across across) const {
    extend_islands(stroke);
    copy_changed(stroke, across);
}

void Seams::copy_changed(StrokeTiles& stroke, Across across) const {
    if (across == Across::slopes) bends_.follow(stroke);
    const std::vector<std::uint32_t> tiles = stroke.dirty();  // copies may add to it
    for (const std::uint32_t tile : tiles) {
        const TexelRect dirty = stroke.tile(tile)->dirty;
        visit_tile(copies_of_tile_, tile, [&](std::uint32_t i) {
            if (across == Across::slopes && shifted_[i]) return;
            const Texel from = place(copies_[i].source), to = place(copies_[i].gutter);
            if (dirty.contains(from.x, from.y) || dirty.contains(to.x, to.y))
                stroke.copy(from.x, from.y, to.x, to.y);
        });
    }
}

void Seams::extend_islands(StrokeTiles& stroke) const {
    std::vector<std::uint32_t> changed;
    for (const std::uint32_t tile : stroke.dirty()) {
        const TexelRect dirty = stroke.tile(tile)->dirty;
        visit_tile(loose_of_tile_, tile, [&](std::uint32_t i) {
            const auto& sources = loose_[i].sources;
            if (std::any_of(sources.begin(), sources.end(),
                            [&](const Weighted& s) { return dirty.contains(s.at.x, s.at.y); }))
                changed.push_back(i);
        });
    }
    sort_unique(changed);
    for (const std::uint32_t i : changed) {
        float sum = 0.0f;
        for (const Weighted& source : loose_[i].sources)
            sum += source.weight * stroke.value(source.at.x, source.at.y);
        const Texel at = place(loose_[i].texel);
        stroke.set_value(at.x, at.y, sum);
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

SeamSystem Seams::system_on(const std::vector<std::uint32_t>& unknowns, const StrokeTiles& stroke) const {
    const std::vector<std::uint32_t> chosen = equations_on(unknowns, stroke.grid());
    SeamSystem system;
    system.residual.assign(chosen.size(), 0.0);
    for (std::size_t row = 0; row < chosen.size(); ++row)
        for (int k = 0; k < 8; ++k) {
            const SeamEquation& equation = equations_[chosen[row]];
            if (equation.weight[k] == 0.0f) continue;
            const double weight = double{equation.weight[k]};
            const Texel at = place(equation.texel[k]);
            system.residual[row] -= weight * double{stroke.value(at.x, at.y)};
            const auto found = std::lower_bound(unknowns.begin(), unknowns.end(), equation.texel[k]);
            if (found == unknowns.end() || *found != equation.texel[k]) continue;
            system.entries.push_back({row, static_cast<std::size_t>(found - unknowns.begin()), weight});
        }
    system.unknowns = unknowns.size();
    float low = 65535.0f, high = 0.0f;
    for (const std::uint32_t texel : unknowns) {
        const Texel at = place(texel);
        if (is_loose(texel)) continue;
        low =
            std::min(low, std::min(stroke.value(at.x, at.y), static_cast<float>(stroke.before(at.x, at.y))));
        high =
            std::max(high, std::max(stroke.value(at.x, at.y), static_cast<float>(stroke.before(at.x, at.y))));
    }
    system.relief = std::max(0.0, double{high} - double{low});
    return system;
}

void Seams::copy_all(HeightMap& map) const {
    for (const SeamCopy& copy : copies_) map.texels()[copy.gutter] = map.texels()[copy.source];
}

void Seams::settle(StrokeTiles& stroke, Across across, const HeightMap* mask) const {
    std::vector<std::uint32_t> unknowns = touched_texels(stroke);
    if (mask) std::erase_if(unknowns, [&](std::uint32_t t) { return mask->texels()[t] == 65535; });
    if (unknowns.empty()) return;
    const std::vector<double> steps = solve_seam(system_on(unknowns, stroke));
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const Texel at = place(unknowns[i]);
        stroke.set_change(at.x, at.y, stroke.change(at.x, at.y) + static_cast<float>(steps[i]));
    }
    copy_changed(stroke, across);
}

}  // namespace relievo
