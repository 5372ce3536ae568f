// The tools: draw, level, erase; smooth by a texel-grid step and a world-space low-pass; flatten by a plane
// fit.
#include "brushes/dab_tools.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "brushes/low_pass.h"
#include "brushes/seams.h"

namespace relievo {
namespace {

constexpr float kTop = 65535.0f;

struct Work {
    const Brush& brush;
    const DabPlace& place;
    const Surface& surface;
    StrokeTiles& stroke;
    double counts_per_unit;  // of world height, signed; finite

    float weight(const SurfaceTexel& texel) const {
        const float part = std::min(texel.distance / brush.radius, 1.0f);
        return brush.strength * place.pressure * falloff_weight(brush.falloff, brush.hardness, part);
    }
    float weight_of_step(const SurfaceTexel& texel) const {
        return std::min(weight(texel) * (brush.spacing / kUnitSpacing), 1.0f);
    }
    float change(const SurfaceTexel& t) const { return stroke.change(t.x, t.y); }
    float value(const SurfaceTexel& t) const { return stroke.value(t.x, t.y); }
    std::vector<SurfaceTexel> texels(float radius) const {
        std::vector<SurfaceTexel> found;
        surface.texels_in_ball(place.centre.position, radius, found);
        return found;
    }
};

void draw(const Work& work) {
    const Brush& brush = work.brush;
    const double rise = double{kDrawRise} * double{brush.radius} * double{brush.spacing} *
                        work.counts_per_unit * (brush.invert ? -1.0 : 1.0);
    // A dab cannot need more than the whole range; the bound keeps 0 * infinity out for tiny amplitudes.
    const auto counts = static_cast<float>(std::clamp(rise, -2.0 * double{kTop}, 2.0 * double{kTop}));
    for (const SurfaceTexel& texel : work.texels(brush.radius)) {
        const float add = counts * work.weight(texel);
        if (add != 0.0f) work.stroke.set_change(texel.x, texel.y, work.change(texel) + add);
    }
}

void move_to(const Work& work, float target) {
    for (const SurfaceTexel& texel : work.texels(work.brush.radius)) {
        const float before = static_cast<float>(work.stroke.before(texel.x, texel.y));
        const float change = (target - before) * work.weight(texel);
        if (std::abs(change) > std::abs(work.change(texel))) work.stroke.set_change(texel.x, texel.y, change);
    }
}

// Half the texel, half the mean of those of its four neighbours that show the surface: what flattens a spike
// whose foot is out of the ball's reach.
float grid_mean(const Work& work, const Seams& seams, const TexelRect& map, const SurfaceTexel& texel) {
    constexpr int kStep[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    float sum = 0.0f, count = 0.0f;
    for (const auto& step : kStep) {
        const int x = texel.x + step[0], y = texel.y + step[1];
        if (x < 0 || y < 0 || x >= map.x1 || y >= map.y1) continue;
        if (!work.surface.owned(x, y) && !seams.is_gutter(x, y)) continue;
        sum += work.stroke.value(x, y);
        count += 1.0f;
    }
    const float own = work.value(texel);
    return count > 0.0f ? 0.5f * (own + sum / count) : own;
}

void smooth(const Work& work, const Seams& seams) {
    // The averages take in a margin around the brush, and where it covers only a few texels, their
    // neighbourhood.
    constexpr std::size_t kFewTexels = 24;
    const float radius = work.brush.radius;
    float reach = 1.25f * radius;
    std::vector<SurfaceTexel> texels = work.texels(reach);
    for (int doubled = 0; doubled < 4 && texels.size() < kFewTexels; ++doubled)
        texels = work.texels(reach *= 2.0f);
    if (texels.empty()) return;

    const float texel_spacing = reach * std::sqrt(3.14159265f / static_cast<float>(texels.size()));
    const float cell = std::clamp(2.0f * texel_spacing, 0.25f * radius, std::max(reach, 0.25f * radius));
    LowPass average(work.place.centre.position, reach, cell);
    const auto is_back = [&](const SurfaceTexel& t) {
        return glm::dot(t.normal, work.place.centre.normal) < 0.0f;
    };
    const TexelRect map = work.stroke.grid().bounds();
    for (const SurfaceTexel& t : texels) average.add(t.position, is_back(t), grid_mean(work, seams, map, t));
    for (const SurfaceTexel& t : texels) {
        if (t.distance >= radius) continue;
        const float step = (average.fetch(t.position, is_back(t)) - work.value(t)) * work.weight_of_step(t);
        if (step != 0.0f) work.stroke.set_change(t.x, t.y, work.change(t) + step);
    }
}

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
        mean += double{weights[i]} * (glm::dvec3(texels[i].position) - centre);
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
        const glm::dvec3 d = glm::dvec3(texels[i].position) - centre - mean;
        const double w = double{weights[i]}, du = glm::dot(d, u), dv = glm::dot(d, v), dh = glm::dot(d, axis);
        uu += w * du * du, uv += w * du * dv, vv += w * dv * dv, hu += w * dh * du, hv += w * dh * dv;
    }
    const double ridge = 1e-4 * total * radius * radius;
    uu += ridge, vv += ridge;
    const double determinant = uu * vv - uv * uv;
    const double s = (hu * vv - hv * uv) / determinant, t = (hv * uu - hu * uv) / determinant;
    return {centre + mean, glm::normalize(axis - s * u - t * v)};
}

void flatten(const Work& work) {
    constexpr double kLeastCosine = 0.2;  // beyond, the way to the plane along the normal is too long
    const std::vector<SurfaceTexel> texels = work.texels(work.brush.radius);
    std::vector<float> weights(texels.size());
    for (std::size_t i = 0; i < texels.size(); ++i)
        if (glm::dot(texels[i].normal, work.place.centre.normal) > 0.0f)
            weights[i] = work.weight_of_step(texels[i]);
    const double radius = double{work.brush.radius};
    const Plane plane = fit_plane(texels, weights, glm::dvec3(work.place.centre.position), radius);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const SurfaceTexel& texel = texels[i];
        const double cosine = glm::dot(glm::dvec3(texel.normal), plane.normal);
        if (weights[i] == 0.0f || cosine < kLeastCosine) continue;
        const double way = glm::dot(plane.point - glm::dvec3(texel.position), plane.normal) / cosine;
        // The position is that of the map's rounded texel; the step starts from the unrounded one.
        const float rounded = std::floor(work.value(texel) + 0.5f);
        const double counts = std::clamp(way, -radius, radius) * work.counts_per_unit;
        const float target = rounded + static_cast<float>(std::clamp(counts, -double{kTop}, double{kTop}));
        const float step = (target - work.value(texel)) * weights[i];
        if (step != 0.0f) work.stroke.set_change(texel.x, texel.y, work.change(texel) + step);
    }
}

}  // namespace

float falloff_weight(Falloff falloff, float hardness, float part) {
    const float x = part <= hardness ? 0.0f : (part - hardness) / (1.0f - hardness);
    switch (falloff) {
        case Falloff::smooth:
            return (1.0f - x) * (1.0f - x) * (1.0f + 2.0f * x);
        case Falloff::linear:
            return 1.0f - x;
        case Falloff::sharp:
            return (1.0f - x) * (1.0f - x);
        case Falloff::constant:
            return 1.0f;
    }
    return 0.0f;
}

void apply_dab(const Brush& brush, const DabPlace& place, const Surface& surface, const Seams& seams,
               StrokeTiles& stroke) {
    const double counts_per_unit = double{kTop} / double{surface.amplitude()};
    if (!std::isfinite(counts_per_unit) || counts_per_unit == 0.0) return;
    const Work work{brush, place, surface, stroke, counts_per_unit};
    switch (brush.tool) {
        case Tool::draw:
            return draw(work);
        case Tool::smooth:
            return smooth(work, seams);
        case Tool::flatten:
            return flatten(work);
        case Tool::level:
            return move_to(work, brush.level * kTop);
        case Tool::erase:
            return move_to(work, surface.midlevel() * kTop);
    }
}

}  // namespace relievo
