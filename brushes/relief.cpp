// Moving least squares over a footprint's texels; see the header for the paper and what we changed.
#include "brushes/relief.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "brushes/dab_work.h"
#include "brushes/texel_spacing.h"

namespace relievo {
namespace {

constexpr double kReach = 2.2;  // of a fit, in texel spacings
constexpr std::size_t kFewTexels = 24;
// Of a cell of the wider grids, about: where few sites stand, all of them count; where as many as in a finest
// grid's cells stand side by side, a fit from afar needs no more of them, and would take a hundred times as long.
constexpr std::uint32_t kMostOfCell = 64;
constexpr double kWidening = 4.0;  // of the reach, from grid to grid: islands may differ in scale

std::int64_t cell_of(double place, double cell) {
    return static_cast<std::int64_t>(std::clamp(std::floor(place / cell), -4e5, 4e5));
}

// A margin of texels around a ball, for fits at the rim: its width, and how many texels both hold together.
constexpr float kMargin = 3.0f;  // texels

float margin_of(float ball, std::size_t texels) {
    return kMargin * ball * std::sqrt(3.14159265f / static_cast<float>(texels));
}

std::size_t with_margin(std::size_t texels) {
    const double side = std::sqrt(static_cast<double>(texels)) + double{kMargin} * std::sqrt(3.14159265);
    return static_cast<std::size_t>(side * side);
}

// Weighted sums for a plane about their mean.
struct Sums {
    double w = 0, x = 0, y = 0, v = 0, xx = 0, xy = 0, yy = 0, xv = 0, yv = 0;
    double low = 1e30, high = -1e30;

    void add(double weight, double px, double py, double value) {
        w += weight, x += weight * px, y += weight * py, v += weight * value;
        xx += weight * px * px, xy += weight * px * py, yy += weight * py * py;
        xv += weight * px * value, yv += weight * py * value;
        low = std::min(low, value), high = std::max(high, value);
    }
};

}  // namespace

glm::vec3 base_of(const Work& work, const SurfaceTexel& texel) {
    return base_of(work, texel, work.value(texel));
}

glm::vec3 base_of(const Work& work, const SurfaceTexel& texel, float value) {
    const float count = std::floor(value + 0.5f);
    const float height = work.surface.amplitude() * (count / kTop - work.surface.midlevel());
    return texel.position - height * texel.normal;
}

Relief::Relief(const Work& work, float reach) : Relief(work, work.place.centre.position, reach) {}

Relief::Relief(const Work& work, glm::vec3 centre, float reach) : centre_(centre) {
    std::size_t texels = work.surface.count_in_ball(centre, reach);
    for (int doubled = 0; doubled < 4 && texels < kFewTexels; ++doubled)
        texels = work.surface.count_in_ball(centre, reach *= 2.0f);
    if (texels == 0) return;
    const float ball = reach + margin_of(reach, texels);
    sites_.reserve(with_margin(texels));
    TexelSpacing spacing(double{ball});
    work.surface.visit_ball(centre, ball, [&](std::span<const SurfaceTexel> part) {
        for (const SurfaceTexel& t : part) {
            sites_.push_back({base_of(work, t), t.normal, work.value(t)});
            spacing.add(t, sites_.back().base);
        }
    });
    make_finest(kReach * spacing.value());
}

Relief::Relief(const Work& work, const SurfacePoint& about, float reach) : centre_(about.base) {
    // High relief takes texels out of the ball that stand near the centre on the base mesh: a larger ball
    // finds them.
    constexpr int kMostRounds = 6;
    const glm::vec3 n = about.base_normal;
    const auto beside = [&](glm::vec3 place) { return place - n * glm::dot(place - about.base, n); };
    std::size_t texels = 0;
    float ball = 1.1f * reach;
    for (int round = 0; round < kMostRounds; ++round) {
        float needed = 0.0f;
        texels = 0;
        work.surface.visit_ball(about.position, ball, [&](std::span<const SurfaceTexel> part) {
            texels += part.size();
            for (const SurfaceTexel& t : part)
                if (glm::length(beside(t.position) - about.base) < reach)
                    needed =
                        std::max(needed, 1.1f * std::hypot(reach, glm::dot(t.position - about.position, n)));
        });
        if (texels < kFewTexels) needed = std::max(needed, 2.0f * ball);
        if (needed <= ball) break;
        ball = needed;
    }
    if (texels == 0) return;
    ball += margin_of(ball, texels);
    sites_.reserve(with_margin(texels));
    TexelSpacing spacing(double{ball});
    work.surface.visit_ball(about.position, ball, [&](std::span<const SurfaceTexel> part) {
        for (const SurfaceTexel& t : part) {
            if (!(glm::dot(t.normal, n) > 0.0f)) continue;
            sites_.push_back({beside(base_of(work, t)), n, static_cast<float>(work.stroke.before(t.x, t.y))});
            spacing.add(t, sites_.back().base);
        }
    });
    if (!sites_.empty()) make_finest(kReach * spacing.value());
}

std::vector<std::uint32_t> Relief::place_sites(Grid& grid, const std::vector<std::uint32_t>& places) const {
    return grid.cells.place(static_cast<std::uint32_t>(sites_.size()), [&](std::uint32_t i) {
        const glm::dvec3 d = glm::dvec3(sites_[places.empty() ? i : places[i]].base) - glm::dvec3(centre_);
        const double cell = 2 * grid.reach;
        return CellTable::key(cell_of(d.x, cell), cell_of(d.y, cell), cell_of(d.z, cell));
    });
}

void Relief::make_finest(double fit_reach) {
    for (Grid& grid : grids_) {
        grid.reach = fit_reach;
        fit_reach *= kWidening;
    }
    places_ = place_sites(grids_[0], {});
    // In place: a second list would be as large again.
    std::vector<std::uint32_t> to = places_;
    for (std::uint32_t i = 0; i < to.size(); ++i)
        while (to[i] != i) {
            std::swap(sites_[i], sites_[to[i]]);
            const std::uint32_t next = to[i];
            std::swap(to[i], to[next]);
        }
}

const Relief::Grid& Relief::made(std::size_t level) const {
    Grid& grid = grids_[level];
    if (level > 0)
        std::call_once(grid.made, [&] {
            grid.sites.resize(sites_.size());
            const std::vector<std::uint32_t> places = place_sites(grid, places_);
            for (std::size_t i = 0; i < places.size(); ++i) grid.sites[places[i]] = places_[i];
        });
    return grid;
}

std::optional<double> Relief::fit(std::size_t level, glm::dvec3 base, glm::dvec3 n) const {
    const Grid& grid = made(level);
    constexpr std::size_t kFewest = 3;
    const glm::dvec3 aside = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(n, aside)), v = glm::cross(n, u);
    const double reach = grid.reach, cell = 2 * reach, softness = 1e-6 * reach * reach;
    const glm::dvec3 d = base - glm::dvec3(centre_);
    std::int64_t low[3];
    for (int k = 0; k < 3; ++k) low[k] = cell_of(d[k] - reach, cell);
    const std::uint32_t* order = grid.sites.empty() ? nullptr : grid.sites.data();
    Sums sums;
    std::size_t used = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const auto [first, held] = grid.cells.find(
            CellTable::key(low[0] + (corner & 1), low[1] + (corner >> 1 & 1), low[2] + (corner >> 2 & 1)));
        const std::uint32_t step = level == 0 ? 1 : 1 + held / kMostOfCell;
        for (std::uint32_t i = first; i < first + held; i += step) {
            const Site& site = sites_[order ? order[i] : i];
            const glm::dvec3 offset = glm::dvec3(site.base) - base;
            if (!(glm::dot(glm::dvec3(site.normal), n) > 0.0)) continue;
            const double x = glm::dot(offset, u), y = glm::dot(offset, v), square = x * x + y * y;
            if (square >= reach * reach || std::abs(glm::dot(offset, n)) > reach) continue;
            const double fade = 1.0 - std::sqrt(square) / reach;
            sums.add(fade * fade / (square + softness), x / reach, y / reach, double{site.value});
            ++used;
        }
    }
    if (used < kFewest && level + 1 < kLevels) return std::nullopt;
    if (!(sums.w > 0)) return std::nullopt;
    const double x = sums.x / sums.w, y = sums.y / sums.w, value = sums.v / sums.w;
    constexpr double kRidge = 1e-10;  // settles sites along a line
    const double xx = sums.xx / sums.w - x * x + kRidge, yy = sums.yy / sums.w - y * y + kRidge,
                 xy = sums.xy / sums.w - x * y, xv = sums.xv / sums.w - x * value,
                 yv = sums.yv / sums.w - y * value;
    const double determinant = xx * yy - xy * xy;
    const double sx = (xv * yy - yv * xy) / determinant, sy = (yv * xx - xv * xy) / determinant;
    return std::clamp(value - sx * x - sy * y, sums.low, sums.high);
}

std::optional<double> Relief::at(glm::vec3 base, glm::vec3 normal) const {
    for (std::size_t level = 0; level < kLevels && !sites_.empty(); ++level)
        if (const auto found = fit(level, glm::dvec3(base), glm::dvec3(normal))) return found;
    return std::nullopt;
}

}  // namespace relievo
