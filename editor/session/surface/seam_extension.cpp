#include "editor/session/surface/seam_extension.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <optional>
#include <utility>

#include "editor/session/surface/height_fit.h"
#include "editor/session/surface/pole_fans.h"
#include "editor/session/surface/seam_equations.h"
#include "editor/session/surface/texel_classes.h"
#include "editor/session/surface/texel_triangle.h"

namespace relievo {
namespace {

constexpr double kReach = 2;  // texels from the seam
// Texels of a side on which one of the other's would be longer are too coarse to say anything.
constexpr double kMostStretch = 8;
constexpr std::int64_t kSites = 3;  // texels either way of a place that tell its height

// A texel outside an island and the seam that it is nearest to.
struct Outside {
    double distance;  // texels
    std::size_t seam;
    bool beyond_b;
    glm::dvec2 at;  // in that side's texel space

    bool operator<(const Outside& o) const {
        return distance != o.distance ? distance < o.distance : seam != o.seam ? seam < o.seam : o.beyond_b;
    }
};

// From texels to lengths along the edge and away from it, into the triangle.
std::optional<glm::dmat2> lengths_of(const Mesh& mesh, const MapGrid& grid, const UvSeam& seam,
                                     const UvSide& side) {
    const TexelTriangle triangle = texel_triangle(mesh, side.face, grid);
    if (!can_rasterise(triangle, grid)) return {};
    const glm::dvec3 from(mesh.positions[seam.position[0]]), to(mesh.positions[seam.position[1]]);
    const double length = glm::length(to - from);
    if (!(length > 0)) return {};
    const glm::dvec3 along = (to - from) / length;
    const glm::dmat2x3 space = space_from_texels(mesh, side.face, triangle);
    const glm::dvec3 inside = space * (side.inner - side.from);
    const glm::dvec3 away = inside - along * glm::dot(inside, along);
    const double depth = glm::length(away);
    if (!(depth > 0)) return {};
    const glm::dmat2 result(glm::dot(space[0], along), glm::dot(space[0], away) / depth, glm::dot(space[1], along),
                            glm::dot(space[1], away) / depth);
    return std::isfinite(glm::determinant(result)) && glm::determinant(result) != 0 ? std::optional(result)
                                                                                    : std::nullopt;
}

class Extender {
  public:
    Extender(const Mesh& mesh, const MapGrid& grid, const UvBorders& borders, const TexelClasses& classes)
        : mesh_(mesh),
          grid_(grid),
          seams_(borders.seams),
          classes_(classes),
          poles_(mesh, grid, borders, classes) {}

    std::vector<SeamExtension> extended() {
        for (std::size_t i = 0; i < seams_.size(); ++i) {
            if (seams_[i].aligned) continue;
            collect(seams_[i].a, i, false);
            collect(seams_[i].b, i, true);
        }
        std::vector<SeamExtension> result;
        for (const auto& [texel, outside] : found_) {
            SeamExtension extension = extension_of(outside);
            extension.texel = texel;
            if (!extension.sources.empty()) result.push_back(std::move(extension));
        }
        return result;
    }

  private:
    void collect(const UvSide& side, std::size_t seam, bool beyond_b) {
        const std::vector<double> at = cell_crossings(side);
        const glm::dvec2 d = side.to - side.from;
        const double square = glm::dot(d, d);
        if (!(square > 0)) return;
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            const glm::dvec2 p = side.from + d * ((at[i] + at[i + 1]) / 2);
            const auto reach = static_cast<std::int64_t>(kReach);
            const auto x0 = static_cast<std::int64_t>(std::floor(p.x)),
                       y0 = static_cast<std::int64_t>(std::floor(p.y));
            for (std::int64_t y = y0 - reach; y <= y0 + 1 + reach; ++y)
                for (std::int64_t x = x0 - reach; x <= x0 + 1 + reach; ++x) {
                    const std::uint32_t texel = grid_.index(x, y);
                    if (classes_.owned(texel) || classes_.root(texel) != texel) continue;
                    const glm::dvec2 centre(static_cast<double>(x), static_cast<double>(y));
                    const double t = std::clamp(glm::dot(centre - side.from, d) / square, 0.0, 1.0);
                    const Outside outside{glm::distance(centre, side.from + d * t), seam, beyond_b, centre};
                    if (outside.distance > kReach) continue;
                    const auto [slot, fresh] = found_.try_emplace(texel, outside);
                    if (!fresh && outside < slot->second) slot->second = outside;
                }
        }
    }

    SeamExtension extension_of(const Outside& outside) const {
        const UvSeam& seam = seams_[outside.seam];
        const UvSide &here = outside.beyond_b ? seam.b : seam.a, &there = outside.beyond_b ? seam.a : seam.b;
        if (auto about_pole = poles_.sources(here.face, outside.at); !about_pole.empty())
            return {0, std::move(about_pole)};
        const auto lengths_here = lengths_of(mesh_, grid_, seam, here),
                   lengths_there = lengths_of(mesh_, grid_, seam, there);
        if (!lengths_here || !lengths_there) return {};
        glm::dvec2 way = *lengths_here * (outside.at - here.from);
        way.y = -way.y;  // what is outside here is inside there
        const glm::dvec2 step = glm::inverse(*lengths_there) * way;
        if (!(glm::length(step) < kMostStretch * (glm::length(outside.at - here.from) + 1))) return {};
        return height_at(there.from + step);
    }

    SeamExtension height_at(glm::dvec2 p) const {
        std::vector<FitSite> around;
        const auto x0 = static_cast<std::int64_t>(std::floor(p.x)),
                   y0 = static_cast<std::int64_t>(std::floor(p.y));
        for (std::int64_t y = y0 - kSites + 1; y <= y0 + kSites; ++y)
            for (std::int64_t x = x0 - kSites + 1; x <= x0 + kSites; ++x) {
                const std::uint32_t texel = grid_.index(x, y);
                if (!classes_.owned(texel)) continue;
                around.push_back({texel, glm::dvec2(static_cast<double>(x), static_cast<double>(y)) - p});
            }
        return {0, fitted_height(around)};
    }

    const Mesh& mesh_;
    const MapGrid& grid_;
    const std::vector<UvSeam>& seams_;
    const TexelClasses& classes_;
    const PoleFans poles_;
    std::map<std::uint32_t, Outside> found_;
};

}  // namespace

std::vector<SeamExtension> extend_over_seams(const Mesh& mesh, const MapGrid& grid, const UvBorders& borders,
                                             const TexelClasses& classes) {
    return Extender(mesh, grid, borders, classes).extended();
}

}  // namespace relievo
