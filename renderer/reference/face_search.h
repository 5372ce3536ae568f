// The first hit of a ray with S over one base triangle, by subdivision with conservative bounds.
//
// A part of the triangle is first a convex polygon over a block of texel cells, cut along texel lines as a
// k-d tree would, and then, inside one cell (or where the map is constant), a triangle on which S is smooth,
// cut in four.
//  - Block: S = P + D n lies in the hull of P_i + D_low N_i/l and P_i + D_high N_i/l over the polygon's
//  corners, grown
//    by max|D| (l_high - l_low)/(l_high + l_low), where |N| lies in [l_low, l_high] and l is the middle.
//  - Smooth part: S lies in the triangle of its corners grown by the sag (face_shape.h), which falls by four
//  with
//    every cut, so that grazing rays do not multiply the parts.
// A part is dropped when the ray misses its bound, or meets it outside [z_min, best]. It is solved when
// bounds of the derivative across the ray show that S folds over no point of the ray's plane there (one root
// at most) and Newton's method finds it inside; else it is cut, nearest part first. A part whose sag is
// within rounding and which has no unique root is touched by a tangent ray, or holds it: a hit.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/reference/face_shape.h"
#include "renderer/reference/ray_frame.h"
#include "renderer/reference/reference_object.h"

namespace relievo::reference {

// The best hit so far, of all faces.
struct FoundHit {
    double z;  // along the unit ray
    const FaceShape* shape;
    DomainPoint at;
    CellPatch patch;
};

class FaceSearch {
  public:
    FaceSearch(const RayFrame& frame, double z_min, double z_max, std::uint64_t node_limit)
        : frame_(frame), z_min_(z_min), z_max_(z_max), node_limit_(node_limit) {}

    // Looks for a hit on the face before z_max(), which falls to it.
    void search(const ObjectData& object, const FaceShape& shape);

    const std::optional<FoundHit>& found() const { return found_; }
    const double& z_max() const { return z_max_; }
    std::uint64_t nodes() const { return nodes_; }
    bool exhausted() const { return nodes_ >= node_limit_; }

  private:
    static constexpr int kMostCorners = 8;  // a triangle cut by four lines has at most 7
    struct Part {
        std::array<DomainPoint, kMostCorners> points;
        int count;
        bool smooth;
        double z_low;
        // Block.
        Cells cells;
        // Smooth part.
        CellPatch patch;
        std::array<glm::dvec3, 3> corners;  // S in the ray's frame
        Curvature curvature;
        double rounding;         // of the corners
        double shortest_normal;  // 0: N may vanish on it, the curvature is unknown
    };
    enum class Root { inside, outside, unknown };
    // A place of a smooth part as fractions of its two edges, and z there.
    struct LocalRoot {
        double c1, c2, z;
    };

    bool bound_block(const Interval& range, Part& part) const;
    bool bound_smooth(Part& part) const;
    bool reached(std::span<const glm::dvec3> points, double radius, Part& part) const;
    double rounding(std::span<const glm::dvec3> points) const;
    static bool is_a_line(const Part& part);  // within rounding of the barycentrics
    Part clipped(const Part& part, int axis, double line, bool keep_low) const;

    void start();
    void open_block(const Part& part);
    void open_smooth(const Part& part);
    void cut_smooth(const Part& part);
    void push_nearest_last(std::span<Part> parts);
    bool has_unique_root(const Part& part) const;
    Root newton(const Part& part, LocalRoot& root) const;
    void accept(const Part& part, const LocalRoot& root);
    void accept_touch(const Part& part);

    const RayFrame& frame_;
    double z_min_, z_max_;
    std::uint64_t nodes_ = 0, node_limit_;
    std::optional<FoundHit> found_;
    std::vector<Part> stack_;
    const ObjectData* object_ = nullptr;
    const FaceShape* shape_ = nullptr;
    double face_size_ = 0;  // largest coordinate on the face: its rounding's scale
};

}  // namespace relievo::reference
