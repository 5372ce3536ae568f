// See ray_judge.h.
#include "renderer/stability/ray_judge.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "renderer/stability/float_floor.h"

namespace relievo::stability {
namespace {

using glm::dvec3;

constexpr double kOff = 0.01;        // of the unit, as in the judge of images
constexpr double kOnSurface = 1e-4;  // of the unit: how far a hit may lie off S
constexpr double kNear = 16;         // roundings: how far a ray may be moved
constexpr int kExamples = 4;
constexpr double kFar = std::numeric_limits<double>::max();

}  // namespace

RayJudge::RayJudge(const Case& c, const ReferenceSurface& surface, const RaySet& set)
    : surface_(surface), rays_(set.rays) {
    double largest = 0, reach = 0;
    for (Ray& ray : rays_) {
        ray.direction = glm::normalize(ray.direction);  // as picking does
        answers_.push_back(answer(dvec3(ray.origin), dvec3(ray.direction)));
        for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(static_cast<double>(ray.origin[k])));
        if (answers_.back().hit) reach = std::max(reach, answers_.back().t);
    }
    rounding_ = 0x1p-23 * (largest + reach);
    units_ = float_units(c, dvec3(largest), reach);
}

RayJudge::Answer RayJudge::answer(const dvec3& origin, const dvec3& direction) {
    const ReferenceAnswer found = surface_.trace(origin, direction, 0, kFar);
    if (found.undecided) ++undecided_;
    if (!found.hit) return {};
    return {true, found.hit->object, found.hit->t, found.hit->normal};
}

bool RayJudge::agrees(const Answer& answer, const PickHit& pick) const {
    if (answer.hit != pick.hit) return false;
    return !pick.hit ||
           std::abs(static_cast<double>(pick.distance) - answer.t) <= kOff * units_[answer.object].length;
}

bool RayJudge::on_surface(const Ray& ray, const PickHit& pick) const {
    const dvec3 at = dvec3(ray.origin) + dvec3(ray.direction) * static_cast<double>(pick.distance);
    const ReferencePoint point =
        surface_.evaluate(pick.object, pick.face, static_cast<double>(pick.b1), static_cast<double>(pick.b2));
    return glm::distance(at, point.position) <= kOnSurface * units_[pick.object].length + kNear * rounding_;
}

bool RayJudge::explained(const Ray& ray, const PickHit& pick) const {
    if (pick.hit && !on_surface(ray, pick)) return false;
    const dvec3 origin(ray.origin), direction(ray.direction);
    double reach = kFar;  // that a ray must come without a hit
    if (pick.hit)
        reach =
            static_cast<double>(pick.distance) - kOnSurface * units_[pick.object].length - kNear * rounding_;
    if (reach <= 0) return true;
    for (std::uint32_t k = 0; k < 48; ++k) {
        const double size = rounding_ * (k < 16 ? 1 : k < 32 ? 4 : kNear);
        const auto shift = [&](std::uint32_t seed) {
            return dvec3(hash01(k, 0, seed), hash01(k, 1, seed), hash01(k, 2, seed)) * 2.0 - 1.0;
        };
        const dvec3 from = origin + shift(1) * size;
        const dvec3 to = origin + direction + shift(2) * size;
        if (!surface_.first_hit(from, glm::normalize(to - from), 0, reach)) return true;
    }
    return false;
}

double RayJudge::normal_deg(const Ray& ray, const PickHit& pick, const dvec3& expected) const {
    const dvec3 n(pick.normal);
    const auto angle = [&](const dvec3& other) {
        return glm::degrees(std::acos(std::clamp(glm::dot(n, other), -1.0, 1.0)));
    };
    const double first = angle(expected);
    if (!on_surface(ray, pick)) return first;
    // On an edge or a texel's border the normal of either side is right.
    return std::min(first, angle(surface_
                                     .evaluate(pick.object, pick.face, static_cast<double>(pick.b1),
                                               static_cast<double>(pick.b2))
                                     .normal));
}

ImageComparison RayJudge::compare(std::span<const PickHit> picks) const {
    ImageComparison result;
    std::vector<double> depth, normal;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        const PickHit& pick = picks[i];
        const Answer& expected = answers_[i];
        const double t = static_cast<double>(pick.distance);
        const dvec3 n(pick.normal);
        if (pick.hit && !std::isfinite(t + n.x + n.y + n.z)) ++result.not_finite;
        if (!pick.hit && !expected.hit) continue;
        if (agrees(expected, pick)) {
            ++result.both;
            const double cosine = std::abs(glm::dot(dvec3(rays_[i].direction), expected.normal));
            const double error = std::abs(t - expected.t) * cosine / units_[expected.object].length;
            // On a torn edge S has two points, a little apart.
            depth.push_back(error > kOnSurface && explained(rays_[i], pick) ? 0 : error);
            normal.push_back(normal_deg(rays_[i], pick, expected.normal));
            continue;
        }
        const bool excused = explained(rays_[i], pick);
        if (!excused) ++result.unexplained;
        if (expected.hit && pick.hit) {
            ++result.both;
            if (!excused) ++result.off;
        } else if (expected.hit) {
            ++(excused ? result.silhouette_missed : result.missed);
        } else {
            ++(excused ? result.silhouette_invented : result.invented);
        }
        if (excused || result.unexplained_examples.size() >= kExamples) continue;
        const OffPixel::Kind kind = expected.hit && pick.hit ? OffPixel::Kind::depth
                                    : expected.hit           ? OffPixel::Kind::missed
                                                             : OffPixel::Kind::invented;
        constexpr double kNothing = std::numeric_limits<double>::infinity();
        result.unexplained_examples.push_back(
            {kind, static_cast<int>(i), 0, expected.hit ? expected.t : kNothing, pick.hit ? t : kNothing});
    }
    result.depth = result.depth_away = rank_errors(std::move(depth));
    result.normal_deg = rank_errors(std::move(normal));
    return result;
}

}  // namespace relievo::stability
