// The tools that even out: smooth by a texel-grid step and a world-space low-pass; flatten and clay by a
// plane fit.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "brushes/dab_work.h"
#include "brushes/low_pass.h"

namespace relievo {
namespace {

// Half the texel, half the mean of those of its four neighbours that show the surface: what flattens a spike
// whose foot is out of the ball's reach.
float grid_mean(const Work& work, const TexelRect& map, const SurfaceTexel& texel) {
    constexpr int kStep[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    float sum = 0.0f, count = 0.0f;
    double exact = 0.0;
    for (const auto& step : kStep) {
        const int x = texel.x + step[0], y = texel.y + step[1];
        if (x < 0 || y < 0 || x >= map.x1 || y >= map.y1) continue;
        if (!work.surface.owned(x, y) && !work.seams.is_gutter(x, y)) continue;
        sum += work.stroke.value(x, y);
        exact += double{work.stroke.value(x, y)};
        count += 1.0f;
    }
    // In mirrored texels the neighbours come in another order, and float would round differently. Without
    // mirrors it stays float, as journals were recorded.
    const Brush& brush = work.brush;
    if (brush.mirror_x || brush.mirror_y || brush.mirror_z) sum = static_cast<float>(exact);
    const float own = work.value(texel);
    return count > 0.0f ? 0.5f * (own + sum / count) : own;
}

}  // namespace

SmoothedBall smoothed_ball(const Surface& surface, glm::vec3 centre, float radius) {
    constexpr std::size_t kFewTexels = 24;
    SmoothedBall ball{1.25f * radius, {}};
    surface.texels_in_ball(centre, ball.reach, ball.texels);
    for (int doubled = 0; doubled < 4 && ball.texels.size() < kFewTexels; ++doubled)
        surface.texels_in_ball(centre, ball.reach *= 2.0f, ball.texels);
    return ball;
}

void smooth(const Work& work, const SmoothedBall& ball) {
    const auto& [reach, texels] = ball;
    if (texels.empty()) return;

    const float radius = work.place.radius;
    const float texel_spacing = reach * std::sqrt(3.14159265f / static_cast<float>(texels.size()));
    const float cell = std::clamp(2.0f * texel_spacing, 0.25f * radius, std::max(reach, 0.25f * radius));
    LowPass average(work.place.centre.position, reach, cell);
    const TexelRect map = work.stroke.grid().bounds();
    for (const SurfaceTexel& t : texels) average.add(t.position, work.is_back(t), grid_mean(work, map, t));
    for (const SurfaceTexel& t : texels) {
        if (t.distance >= radius) continue;
        const float step =
            (average.fetch(t.position, work.is_back(t)) - work.value(t)) * work.weight_of_step(t);
        work.change_to(t, work.change(t) + step);
    }
}

void smooth(const Work& work) {
    smooth(work, smoothed_ball(work.surface, work.place.centre.position, work.place.radius));
}

namespace {

struct Plane {
    glm::dvec3 point, normal;
};

// The height above the tangent plane of the mean normal, fitted linearly: a graph over that plane, so that a
// spike cannot turn the result on its side. Texels weigh by the falloff; those that face away take no part.
Plane fit_plane(const std::vector<SurfaceTexel>& texels, const std::vector<float>& weights, glm::dvec3 centre,
                double radius) {
    glm::dvec3 mean(0.0), axis(0.0);
    double total = 0.0;
    for (std::size_t i = 0; i < texels.size(); ++i) {
        mean += double{weights[i]} * (glm::dvec3(texels[i].shaded()) - centre);
        axis += double{weights[i]} * glm::dvec3(texels[i].normal);
        total += double{weights[i]};
    }
    if (!(total > 0.0) || !(glm::dot(axis, axis) > 0.0)) return {centre, glm::dvec3(0.0)};
    mean /= total;
    axis = glm::normalize(axis);
    const glm::dvec3 aside = std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(axis, aside)), v = glm::cross(axis, u);

    // Normal equations of h = a + s u + t v about the mean; the small ridge settles footprints along a line.
    double uu = 0, uv = 0, vv = 0, hu = 0, hv = 0;
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const glm::dvec3 d = glm::dvec3(texels[i].shaded()) - centre - mean;
        const double w = double{weights[i]}, du = glm::dot(d, u), dv = glm::dot(d, v), dh = glm::dot(d, axis);
        uu += w * du * du, uv += w * du * dv, vv += w * dv * dv, hu += w * dh * du, hv += w * dh * dv;
    }
    const double ridge = 1e-4 * total * radius * radius;
    uu += ridge, vv += ridge;
    const double determinant = uu * vv - uv * uv;
    const double s = (hu * vv - hv * uv) / determinant, t = (hv * uu - hu * uv) / determinant;
    return {centre + mean, glm::normalize(axis - s * u - t * v)};
}

// The signed way of a texel to the plane along its own normal, in counts, from its unrounded value; none
// where that way is too long. The position is that of the map's rounded texel.
std::optional<float> counts_to(const Plane& plane, const SurfaceTexel& texel, const Work& work) {
    constexpr double kLeastCosine = 0.2;
    const double cosine = glm::dot(glm::dvec3(texel.normal), plane.normal);
    if (cosine < kLeastCosine) return std::nullopt;
    const double way = glm::dot(plane.point - glm::dvec3(texel.shaded()), plane.normal) / cosine;
    const float rounded = std::floor(work.value(texel) + 0.5f);
    const double radius = double{work.place.radius};
    const double counts = std::clamp(way, -radius, radius) * work.counts_per_unit;
    const float target = rounded + static_cast<float>(std::clamp(counts, -double{kTop}, double{kTop}));
    return target - work.value(texel);
}

// The plane through the texels that face as the dab does.
Plane plane_through(const Work& work, const std::vector<SurfaceTexel>& texels, std::vector<float>& weights) {
    for (std::size_t i = 0; i < texels.size(); ++i)
        if (glm::dot(texels[i].normal, work.place.centre.normal) <= 0.0f) weights[i] = 0.0f;
    return fit_plane(texels, weights, glm::dvec3(work.place.centre.position), double{work.place.radius});
}

}  // namespace

void flatten(const Work& work) {
    const std::vector<SurfaceTexel> texels = work.texels(work.place.radius);
    std::vector<float> weights(texels.size());
    for (std::size_t i = 0; i < texels.size(); ++i) weights[i] = work.weight_of_step(texels[i]);
    const Plane plane = plane_through(work, texels, weights);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        if (weights[i] == 0.0f) continue;
        if (const auto way = counts_to(plane, texels[i], work))
            work.change_to(texels[i], work.change(texels[i]) + *way * weights[i]);
    }
}

void clay(const Work& work) {
    constexpr double kMostWay = 3.0;  // what lies deep fills at most so much faster
    const std::vector<SurfaceTexel> texels = work.texels(work.place.radius);
    std::vector<float> weights(texels.size());
    for (std::size_t i = 0; i < texels.size(); ++i) weights[i] = work.falloff(texels[i]);
    Plane plane = plane_through(work, texels, weights);
    const double offset = double{kDrawRise} * double{kUnitSpacing} * double{work.place.radius};
    plane.point += plane.normal * (offset * double{work.sign()});
    const float most = std::abs(work.counts(kMostWay * offset));
    // Up in space is down in the map where the amplitude is negative.
    const float up = (work.counts_per_unit > 0.0 ? 1.0f : -1.0f) * work.sign();
    for (std::size_t i = 0; i < texels.size(); ++i) {
        if (weights[i] == 0.0f) continue;
        const auto way = counts_to(plane, texels[i], work);
        if (!way || *way * up <= 0.0f) continue;
        const float step = std::clamp(*way, -most, most) * work.weight_of_step(texels[i]);
        work.change_to(texels[i], work.change(texels[i]) + step);
    }
}

}  // namespace relievo
