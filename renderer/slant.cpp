// See slant.h.
#include "renderer/slant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace relievo {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kMuchLower = 0.7;      // of the prism's height
constexpr double kSteepest = 3.5;       // a slant, along either axis; the flags' bits reach to 4
constexpr double kLeastAlongSides = 0.25;  // a side's rise over a slanted plane, per unit of its own height

struct Slant {
    int x, y;  // in steps of gpu::kSlantStep
    dvec2 rise() const { return dvec2(x, y) * double{gpu::kSlantStep}; }
};

// That of the hull's own plane.
std::optional<Slant> slant_of(const gpu::Primitive& p, const SurfaceHull& hull) {
    const dvec3 ng = p.ng, tangent = p.tangent, facing = hull.facing;
    const dvec2 along(glm::dot(facing, tangent), glm::dot(facing, glm::cross(ng, tangent)));
    const dvec2 rise = -along / glm::dot(facing, ng);
    if (!(std::abs(rise.x) <= kSteepest && std::abs(rise.y) <= kSteepest)) return std::nullopt;
    const Slant slant{static_cast<int>(std::lround(rise.x / gpu::kSlantStep)),
                      static_cast<int>(std::lround(rise.y / gpu::kSlantStep))};
    if (slant.x == 0 && slant.y == 0) return std::nullopt;
    return slant;
}

// The displacements up to which the prism reaches between two slanted planes: most at its edges.
std::optional<DisplacementRange> reach_of(const gpu::Primitive& p, const dvec2& rise, const Extent& ends,
                                          const DisplacementRange& range) {
    const std::array<dvec2, 3> corners{dvec2(0), dvec2(p.q1x, 0), dvec2(p.q2)}, shifts{p.shift0, p.shift1, p.shift2};
    DisplacementRange reach = range;
    for (std::size_t i = 0; i < 3; ++i) {
        const double along = 1 - glm::dot(rise, shifts[i]);
        if (!(along >= kLeastAlongSides)) return std::nullopt;
        const double longest = std::sqrt(1 + glm::dot(shifts[i], shifts[i])) / along;
        for (const double end : {ends.low, ends.high}) {
            const double height = (end + glm::dot(rise, corners[i])) * longest;
            reach = {std::min(reach.low, height), std::max(reach.high, height)};
        }
    }
    return reach;
}

}  // namespace

gpu::Primitive with_slant(const MappedTriangle& triangle, const SurfaceHull& hull) {
    constexpr std::uint32_t kNoPrism = gpu::kPrimitiveSearched | gpu::kPrimitiveFolded;
    const gpu::Primitive& p = triangle.primitive;
    const auto slant = (p.flags & kNoPrism) == 0 ? slant_of(p, hull) : std::nullopt;
    if (!slant) return p;
    const dvec2 rise = slant->rise();
    const dvec3 ng = p.ng, tangent = p.tangent, across = ng - tangent * rise.x - glm::cross(ng, tangent) * rise.y;
    const Extent ends = extent_along(hull, across, dvec3(p.origin));
    if (!(ends.high - ends.low < kMuchLower * (double{p.w_high} - double{p.w_low}))) return p;
    const auto reach = reach_of(p, rise, ends, triangle.range);
    if (!reach) return p;
    // There the sides must be as sound as they are within the surface's own heights.
    gpu::Primitive slanted = p;
    set_shell(slanted, triangle.normals, *reach);
    if ((slanted.flags & kNoPrism) != 0) return p;
    slanted.shell_margin = std::max(slanted.shell_margin, p.shell_margin);
    slanted.w_low = static_cast<float>(ends.low);
    slanted.w_high = static_cast<float>(ends.high);
    slanted.flags |= (static_cast<std::uint32_t>(slant->x) << gpu::kSlantShiftX & gpu::kSlantMaskX) |
                     static_cast<std::uint32_t>(slant->y) << gpu::kSlantShiftY;
    return slanted;
}

}  // namespace relievo
