// See edge_gap.h.
#include "renderer/judge/edge_gap.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <thread>

#include "renderer/scene/mesh_topology.h"

namespace relievo {
namespace {

using glm::dvec3;

constexpr double kHair = 1e-4;   // of the way from the edge to the opposite corner
constexpr double kWide = 1e-3;   // of the unit
constexpr double kLeak = 1e-2;   // of the unit
constexpr double kClose = 0.01;  // as kHair: where the surface must be seen as well
constexpr double kLeastCosine = 0.25;
// The edge is neared in stages, each starting from what the one before learned.
constexpr double kInsets[] = {0.2, 0.2, 0.06, 0.06, 0.02, 0.02, 0.005, 0.005};
constexpr double kNear = 0.07;  // a reading within it tells of the edge

dvec3 to_float(const dvec3& v) {
    return dvec3(glm::vec3(v));
}

// A number in [0, 1) from an edge and a place on it: the same everywhere.
double scatter(std::size_t edge, int place) {
    std::uint64_t h =
        edge * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(place) * 0xd1b54a32d192ed03u + 1;
    h ^= h >> 31;
    h *= 0xbf58476d1ce4e5b9u;
    h ^= h >> 29;
    return static_cast<double>(h >> 11) * 0x1p-53;
}

std::array<double, 3> inset_weights(const std::array<double, 3>& weights, std::uint32_t opposite,
                                    double inset) {
    std::array<double, 3> result{};
    for (std::uint32_t i = 0; i < 3; ++i) result[i] = i == opposite ? inset : weights[i] * (1 - inset);
    return result;
}

struct InnerEdge {
    std::uint32_t object;
    std::size_t edge;
};

}  // namespace

struct EdgeProbe::Reading {
    dvec3 error{0};                                          // X - S
    double inset = std::numeric_limits<double>::infinity();  // where it was read
};

EdgeProbe::EdgeProbe(const ReferenceSurface& surface, const Scene& scene, int points) : surface_(surface) {
    const std::vector<ErrorUnit> units = error_units(scene);
    std::vector<MeshTopology> topologies;
    std::vector<InnerEdge> inner;
    for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
        const Mesh& mesh = scene.objects[o].mesh;
        topologies.push_back(find_edges(mesh));
        const MeshTopology& topology = topologies.back();
        for (std::size_t e = 0; e < topology.edges.size(); ++e) {
            const MeshEdge& edge = topology.edges[e];
            if (!edge.is_manifold()) continue;
            const auto sides = topology.sides_of(edge);
            if (has_no_area(mesh, mesh.faces[sides[0].face]) || has_no_area(mesh, mesh.faces[sides[1].face]))
                continue;
            inner.push_back({o, e});
        }
    }
    if (inner.empty()) return;
    const auto wanted = static_cast<std::size_t>(points);
    std::vector<Place> places;
    for (std::size_t k = 0; k < wanted; ++k) {
        // Spread over the edges; several on one where there are few.
        const std::size_t i = inner.size() >= wanted ? k * inner.size() / wanted : k % inner.size();
        const int round = static_cast<int>(k / inner.size());
        const MeshTopology& topology = topologies[inner[i].object];
        const MeshEdge& edge = topology.edges[inner[i].edge];
        places.push_back(place_on(scene.objects[inner[i].object].mesh, edge, topology.sides_of(edge),
                                  0.1 + 0.8 * scatter(i, round)));
        places.back().object = inner[i].object;
        places.back().unit = units[inner[i].object].length;
        places.back().distance += 3 * places.back().unit;
    }
    keep_seen(std::move(places));
}

EdgeProbe::Place EdgeProbe::place_on(const Mesh& mesh, const MeshEdge& edge, std::span<const EdgeSide> sides,
                                     double fraction) {
    Place place;
    const dvec3 p0(mesh.positions[edge.p0]), p1(mesh.positions[edge.p1]);
    place.distance = glm::length(p1 - p0);
    for (std::size_t k = 0; k < 2; ++k) {
        Side& side = place.sides[k];
        side.face = sides[k].face;
        const std::uint32_t corner = sides[k].corner, next = (corner + 1) % 3;
        side.opposite = (corner + 2) % 3;
        const bool forward = mesh.faces[side.face].position[corner] == edge.p0;
        side.weights = {};
        side.weights[corner] = forward ? 1 - fraction : fraction;
        side.weights[next] = forward ? fraction : 1 - fraction;
    }
    return place;
}

ReferencePoint EdgeProbe::at(const Place& place, const Side& side, double inset) const {
    const std::array<double, 3> w = inset_weights(side.weights, side.opposite, inset);
    return surface_.evaluate(place.object, side.face, w[1], w[2]);
}

ReferenceRay EdgeProbe::aim(const Place& place, const dvec3& point) const {
    const dvec3 direction = to_float(-place.outwards);
    return {to_float(point - direction * place.distance), direction};
}

// Whether the reference's ray meets the side's own point first, and not along the surface.
bool EdgeProbe::sees(const Place& place, const Side& side, double inset) const {
    const ReferencePoint point = at(place, side, inset);
    if (!(glm::dot(point.normal, place.outwards) > kLeastCosine)) return false;
    const ReferenceRay ray = aim(place, point.position);
    const double length = glm::length(ray.direction), slack = kWide * place.unit;
    // What lies behind the point is of no interest.
    const auto hit = surface_.first_hit(ray.origin, ray.direction, 0, (place.distance + slack) / length);
    return hit && std::abs(hit->t * length - place.distance) < slack;
}

bool EdgeProbe::choose_view(Place& place) const {
    const dvec3 a = at(place, place.sides[0], kHair).normal, b = at(place, place.sides[1], kHair).normal;
    const dvec3 middle = a + b;
    if (!(glm::length(middle) > 0.1)) return false;
    const dvec3 across =
        glm::normalize(glm::cross(middle, std::abs(middle.x) < 0.7 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
    const dvec3 views[] = {middle, middle + 0.8 * across, middle - 0.8 * across,
                           middle + glm::cross(middle, across), middle - glm::cross(middle, across)};
    const double far = place.distance;
    for (const double distance : {far, far / 8, far / 64}) {
        place.distance = distance;
        for (const dvec3& view : views) {
            place.outwards = glm::normalize(view);
            const auto seen = [&](const Side& side) {
                return sees(place, side, kHair) && sees(place, side, kClose);
            };
            if (!seen(place.sides[0]) || !seen(place.sides[1])) continue;
            for (Side& side : place.sides) {
                side.straight = aim(place, at(place, side, kHair).position);
                const auto hit = surface_.first_hit(side.straight.origin, side.straight.direction, 0,
                                                    std::numeric_limits<double>::infinity());
                side.straight_depth = hit ? hit->t : std::numeric_limits<double>::infinity();
            }
            return true;
        }
    }
    return false;
}

// Keeps the places that have a view. Where texels hide most of the surface, many have none.
void EdgeProbe::keep_seen(std::vector<Place> places) {
    std::vector<char> seen(places.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t i = next++; i < places.size(); i = next++) seen[i] = choose_view(places[i]);
    };
    std::vector<std::thread> helpers;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers) helper.join();
    for (std::size_t i = 0; i < places.size(); ++i)
        if (seen[i]) places_.push_back(places[i]);
}

// Aims at where the method should show the places at `inset`, by what is known of its errors, and reads them
// anew.
void EdgeProbe::refine(const TraceRays& trace, double inset, std::vector<Reading>& readings) const {
    std::vector<ReferenceRay> rays;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const Place& place = places_[i / 2];
        rays.push_back(aim(place, at(place, place.sides[i % 2], inset).position + readings[i].error));
    }
    const std::vector<MethodHit> hits = trace(rays);
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const Place& place = places_[i / 2];
        const Side& side = place.sides[i % 2];
        const MethodHit& hit = hits[i];
        if (!hit.hit || hit.object != place.object || hit.face != side.face) continue;
        const std::array<double, 3> b{1 - hit.b1 - hit.b2, hit.b1, hit.b2};
        const std::array<double, 3> target = inset_weights(side.weights, side.opposite, inset);
        double off = 0;
        for (std::size_t k = 0; k < 3; ++k) off = std::max(off, std::abs(b[k] - target[k]));
        if (!(off <= std::max(inset / 2, 0.01))) continue;
        const dvec3 shown = rays[i].origin + glm::normalize(rays[i].direction) * hit.t;
        readings[i] = {shown - surface_.evaluate(place.object, side.face, hit.b1, hit.b2).position, inset};
    }
}

void EdgeProbe::count_leaks(const TraceRays& trace, EdgeGap& result) const {
    std::vector<ReferenceRay> rays;
    for (const Place& place : places_)
        for (const Side& side : place.sides) rays.push_back(side.straight);
    const std::vector<MethodHit> hits = trace(rays);
    result.rays = static_cast<int>(rays.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const Place& place = places_[i / 2];
        const double expected = place.sides[i % 2].straight_depth * glm::length(rays[i].direction);
        if (!hits[i].hit || !(std::abs(hits[i].t - expected) <= kLeak * place.unit)) ++result.leaks;
    }
}

EdgeGap EdgeProbe::measure(const TraceRays& trace) const {
    EdgeGap result;
    if (places_.empty()) return result;
    std::vector<Reading> readings(places_.size() * 2);
    for (const double inset : kInsets) refine(trace, inset, readings);
    std::vector<double> gaps;
    int wide = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Reading &a = readings[2 * i], &b = readings[2 * i + 1];
        if (a.inset > kNear || b.inset > kNear) {
            ++result.unreached;
            continue;
        }
        gaps.push_back(glm::length(a.error - b.error) / places_[i].unit);
        if (gaps.back() > kWide) ++wide;
    }
    result.points = static_cast<int>(gaps.size());
    if (result.points > 0) result.wide = static_cast<double>(wide) / result.points;
    result.gap = rank_errors(std::move(gaps));
    count_leaks(trace, result);
    return result;
}

}  // namespace relievo
