// The gap of a method along shared edges: how far apart the two triangles of an edge put the same point of
// it.
//
// A method says of every hit which base point it lies over, and where it is: its surface is a map X(face, b),
// to be compared with S(face, b). Near an edge, X - S is read on either side from rays that meet the triangle
// there; the gap is the difference of the two, so that what a torn map tears in S itself does not count. A
// method that projects along other directions in one triangle than in its neighbour (DESIGN.md section 1) has
// a gap, however finely it samples.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "renderer/judge/error_units.h"
#include "renderer/judge/image_comparison.h"
#include "renderer/reference/reference.h"

namespace relievo {

struct MethodHit {
    bool hit = false;
    std::uint32_t object = 0, face = 0;
    double b1 = 0, b2 = 0;
    double t = 0;  // along the unit direction
};

// First hits of a method, one a ray. The rays' numbers are floats already: nothing is lost on the way to a
// device.
using TraceRays = std::function<std::vector<MethodHit>(std::span<const ReferenceRay>)>;

struct EdgeGap {
    int points = 0;     // measured on both sides
    int unreached = 0;  // aimed at, but the method shows no place near the edge on one of its sides
    ErrorRanks gap;     // over the object's unit
    double wide = 0;    // share of the measured points with a gap above 1e-3
    // Rays straight at the edge, a hair to either side, that miss, or hit off by more than a hundredth of the
    // unit.
    int rays = 0, leaks = 0;
};

class EdgeProbe {
  public:
    // Picks about `points` places on the edges between two triangles that the reference sees from outside.
    // `surface` is the scene's and outlives the probe.
    EdgeProbe(const ReferenceSurface& surface, const Scene& scene, int points = 400);

    std::size_t size() const { return places_.size(); }
    EdgeGap measure(const TraceRays& trace) const;

  private:
    struct Side {
        std::uint32_t face;
        std::array<double, 3> weights;  // on the edge: of the face's corners
        std::uint32_t opposite;         // the corner that is not on the edge
        ReferenceRay straight;          // at the edge, a hair inside
        double straight_depth;          // of the reference
    };
    struct Place {
        std::uint32_t object = 0;
        double unit = 1, distance = 0;  // from where rays start to the surface
        glm::dvec3 outwards{0};         // rays run against it
        std::array<Side, 2> sides;
    };
    struct Reading;  // of a side, while it is measured

    static Place place_on(const Mesh& mesh, const struct MeshEdge& edge,
                          std::span<const struct EdgeSide> sides, double fraction);
    void keep_seen(std::vector<Place> places);
    bool choose_view(Place& place) const;
    bool sees(const Place& place, const Side& side, double inset) const;
    ReferencePoint at(const Place& place, const Side& side, double inset) const;
    ReferenceRay aim(const Place& place, const glm::dvec3& point) const;
    void refine(const TraceRays& trace, double inset, std::vector<Reading>& readings) const;
    void count_leaks(const TraceRays& trace, EdgeGap& result) const;

    const ReferenceSurface& surface_;
    std::vector<Place> places_;
};

}  // namespace relievo
