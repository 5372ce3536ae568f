// See face_search.h.
#include "renderer/reference/face_search.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "renderer/scene/cross2.h"

namespace relievo::reference {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
constexpr double kTexelRounding = 4 * std::numeric_limits<double>::epsilon();
// A part smaller than this over which N vanishes: S is not defined there.
constexpr double kSmallestPart = 1e-15;
constexpr int kMostNewtonSteps = 16;

double largest(const dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

DomainPoint middle(const DomainPoint& a, const DomainPoint& b) {
    return {(a.b + b.b) * 0.5, (a.texel + b.texel) * 0.5};
}

// Where the line crosses the edge. The other coordinate stays between the ends, so that a cut polygon stays
// convex along both axes in spite of rounding, and never gains more than a corner.
DomainPoint crossing(const DomainPoint& a, const DomainPoint& b, int axis, double line) {
    const double s = (line - a.texel[axis]) / (b.texel[axis] - a.texel[axis]);
    DomainPoint point{glm::mix(a.b, b.b, s), glm::mix(a.texel, b.texel, s)};
    point.texel = glm::clamp(point.texel, glm::min(a.texel, b.texel), glm::max(a.texel, b.texel));
    point.texel[axis] = line;
    return point;
}

}  // namespace

void FaceSearch::search(const ObjectData& object, const FaceShape& shape) {
    object_ = &object;
    shape_ = &shape;
    const double most_d =
        std::max(std::abs(object.displacement(0.0)), std::abs(object.displacement(65535.0)));
    face_size_ = largest(shape.p) + largest(shape.p1) + largest(shape.p2) + most_d;
    start();
    while (!stack_.empty() && !exhausted()) {
        const Part part = stack_.back();
        stack_.pop_back();
        if (part.z_low > z_max_) continue;
        ++nodes_;
        if (part.smooth) {
            open_smooth(part);
        } else {
            open_block(part);
        }
    }
}

void FaceSearch::start() {
    stack_.clear();
    Part whole{};
    whole.count = 3;
    dvec2 low(1e300), high(-1e300);
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec2 b(i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0);
        whole.points[i] = {b, shape_->texel_at(b)};
        low = glm::min(low, whole.points[i].texel);
        high = glm::max(high, whole.points[i].texel);
    }
    whole.cells = object_->cover(low, high);
    if (bound_block(object_->displacement(object_->heights->range(whole.cells)), whole))
        stack_.push_back(whole);
}

double FaceSearch::rounding(std::span<const dvec3> points) const {
    double size = 0;
    for (const dvec3& point : points) size = std::max(size, largest(point));
    return kRounding * (face_size_ + size);
}

// Whether the ray meets the hull of the points, grown by the radius, between z_min and the best hit.
bool FaceSearch::reached(std::span<const dvec3> points, double radius, Part& part) const {
    double low = points[0].z, high = points[0].z;
    for (const dvec3& point : points) {
        low = std::min(low, point.z);
        high = std::max(high, point.z);
    }
    part.z_low = low - radius;
    return part.z_low <= z_max_ && high + radius >= z_min_ && axis_meets_hull(points, radius);
}

bool FaceSearch::bound_block(const Interval& range, Part& part) const {
    const std::span<const DomainPoint> points(part.points.data(), static_cast<std::size_t>(part.count));
    const LengthRange length = shape_->normal_length(points);
    std::array<dvec3, 2 * kMostCorners> hull;
    std::size_t count = 0;
    double radius = std::max(std::abs(range.low), std::abs(range.high));
    if (length.low > 0) {
        const double scale = 2 / (length.low + length.high);
        for (const DomainPoint& point : points) {
            const dvec3 base = frame_.local(shape_->base(point.b));
            const dvec3 along = frame_.turn(shape_->normal(point.b)) * scale;
            hull[count++] = base + along * range.low;
            hull[count++] = base + along * range.high;
        }
        radius *= (length.high - length.low) / (length.low + length.high);
    } else {
        for (const DomainPoint& point : points) hull[count++] = frame_.local(shape_->base(point.b));
    }
    const std::span<const dvec3> used(hull.data(), count);
    return reached(used, radius + rounding(used), part);
}

bool FaceSearch::bound_smooth(Part& part) const {
    const std::array<DomainPoint, 3> corners{part.points[0], part.points[1], part.points[2]};
    part.shortest_normal = shape_->normal_length(corners).low;
    if (part.shortest_normal > 0) {
        part.curvature = shape_->curvature(part.patch, corners, part.shortest_normal);
        for (std::size_t i = 0; i < 3; ++i)
            part.corners[i] = frame_.local(shape_->position(part.patch, part.points[i]));
        part.rounding = rounding(part.corners);
        for (const DomainPoint& corner : corners) {
            const dvec2 slope = glm::abs(part.patch.gradient(corner.texel)), place = glm::abs(corner.texel);
            part.rounding = std::max(part.rounding, kTexelRounding * (slope.x * place.x + slope.y * place.y));
        }
        return reached(part.corners, part.curvature.sag() + part.rounding, part);
    }
    // N may vanish: S lies within |D| of the base, wherever N points.
    double most_d = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        part.corners[i] = frame_.local(shape_->base(part.points[i].b));
        most_d = std::max(most_d, std::abs(part.patch.at(part.points[i].texel)));
    }
    const dvec2 t1 = corners[1].texel - corners[0].texel, t2 = corners[2].texel - corners[0].texel;
    most_d +=
        std::abs(part.patch.dxy) * (std::abs(t1.x) + std::abs(t2.x)) * (std::abs(t1.y) + std::abs(t2.y));
    part.rounding = rounding(part.corners);
    return reached(part.corners, most_d + part.rounding, part);
}

FaceSearch::Part FaceSearch::clipped(const Part& part, int axis, double line, bool keep_low) const {
    Part half{};
    const auto inside = [&](const DomainPoint& p) {
        return keep_low ? p.texel[axis] <= line : p.texel[axis] >= line;
    };
    dvec2 low(1e300), high(-1e300);
    const auto add = [&](const DomainPoint& p) {
        half.points[static_cast<std::size_t>(half.count++)] = p;
        low = glm::min(low, p.texel);
        high = glm::max(high, p.texel);
    };
    for (int i = 0; i < part.count; ++i) {
        const DomainPoint& a = part.points[static_cast<std::size_t>(i)];
        const DomainPoint& b = part.points[static_cast<std::size_t>((i + 1) % part.count)];
        if (inside(a)) add(a);
        if ((a.texel[axis] < line && b.texel[axis] > line) || (a.texel[axis] > line && b.texel[axis] < line))
            add(crossing(a, b, axis, line));
    }
    if (half.count == 0) return half;
    // The cells that the half covers, inside those of its side of the line.
    Cells side = part.cells;
    (keep_low ? side.high : side.low)[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(line);
    half.cells = object_->cover(low, high);
    for (std::size_t a = 0; a < 2; ++a) {
        half.cells.low[a] = std::clamp(half.cells.low[a], side.low[a], side.high[a] - 1);
        half.cells.high[a] = std::clamp(half.cells.high[a], half.cells.low[a] + 1, side.high[a]);
    }
    return half;
}

bool FaceSearch::is_a_line(const Part& part) {
    const dvec2 e1 = part.points[1].b - part.points[0].b, e2 = part.points[2].b - part.points[0].b;
    const double longest = std::max({glm::length(e1), glm::length(e2), glm::length(e2 - e1)});
    return std::abs(cross2(e1, e2)) <= kRounding * longest;
}

void FaceSearch::open_block(const Part& part) {
    const HeightRange counts = object_->heights->range(part.cells);
    if (part.cells.single() || counts.low == counts.high) {
        std::array<Part, kMostCorners> fan;
        std::size_t count = 0;
        for (std::size_t i = 2; i < static_cast<std::size_t>(part.count); ++i) {
            Part smooth{};
            smooth.points[0] = part.points[0], smooth.points[1] = part.points[i - 1],
            smooth.points[2] = part.points[i];
            // No wider than rounding: its neighbours have it, and cut it would multiply.
            if (is_a_line(smooth)) continue;
            smooth.count = 3;
            smooth.smooth = true;
            smooth.patch = counts.low == counts.high
                               ? ObjectData::flat_patch(object_->displacement(counts.low))
                               : object_->patch(part.cells);
            if (bound_smooth(smooth)) fan[count++] = smooth;
        }
        push_nearest_last({fan.data(), count});
        return;
    }
    const int axis = part.cells.size(0) >= part.cells.size(1) ? 0 : 1;
    const auto line = static_cast<double>(object_->heights->cut(part.cells, axis));
    std::array<Part, 2> halves;
    std::size_t count = 0;
    for (const bool keep_low : {true, false}) {
        Part half = clipped(part, axis, line, keep_low);
        // Less than a triangle is a corner or a side on the line: the other half has it.
        if (half.count < 3) continue;
        if (bound_block(object_->displacement(object_->heights->range(half.cells)), half))
            halves[count++] = half;
    }
    push_nearest_last({halves.data(), count});
}

void FaceSearch::push_nearest_last(std::span<Part> parts) {
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.z_low > b.z_low; });
    stack_.insert(stack_.end(), parts.begin(), parts.end());
}

void FaceSearch::open_smooth(const Part& part) {
    if (!(part.shortest_normal > 0)) {
        const double size = glm::length(part.points[1].b - part.points[0].b) +
                            glm::length(part.points[2].b - part.points[0].b);
        if (size > kSmallestPart) cut_smooth(part);
        return;
    }
    const bool smallest = part.curvature.sag() <= 4 * part.rounding;
    LocalRoot root{};
    const Root answer = has_unique_root(part) ? newton(part, root) : Root::unknown;
    if (answer == Root::inside) {
        accept(part, root);
    } else if (!smallest) {
        cut_smooth(part);
    } else if (answer == Root::unknown) {
        accept_touch(part);
    }
}

void FaceSearch::cut_smooth(const Part& part) {
    const DomainPoint &a = part.points[0], &b = part.points[1], &c = part.points[2];
    const DomainPoint ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    const std::array<std::array<DomainPoint, 3>, 4> quarters{
        {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {bc, ca, ab}}};
    std::array<Part, 4> children;
    std::size_t count = 0;
    for (const auto& quarter : quarters) {
        Part child{};
        std::copy(quarter.begin(), quarter.end(), child.points.begin());
        child.count = 3;
        child.smooth = true;
        child.patch = part.patch;
        if (bound_smooth(child)) children[count++] = child;
    }
    push_nearest_last({children.data(), count});
}

// Between any two places of the part, S across the ray changes by a matrix whose columns lie within turn1 and
// turn2 of the differences of the corners. When none of those matrices is singular, no two places project to
// one point.
bool FaceSearch::has_unique_root(const Part& part) const {
    const dvec2 j1 = dvec2(part.corners[1]) - dvec2(part.corners[0]);
    const dvec2 j2 = dvec2(part.corners[2]) - dvec2(part.corners[0]);
    const double turn1 = part.curvature.turn1(), turn2 = part.curvature.turn2();
    return std::abs(cross2(j1, j2)) > glm::length(j1) * turn2 + glm::length(j2) * turn1 + turn1 * turn2 +
                                          2 * part.rounding * (glm::length(j1) + glm::length(j2));
}

// Newton's method on S across the ray in fractions of the part's edges. `inside` is the part, closed, and as
// much more as rounding may move a root.
FaceSearch::Root FaceSearch::newton(const Part& part, LocalRoot& root) const {
    const dvec2 e1 = part.points[1].b - part.points[0].b, e2 = part.points[2].b - part.points[0].b;
    dvec2 c(1.0 / 3);
    double last_step = std::numeric_limits<double>::max();
    for (int step = 0; step < kMostNewtonSteps; ++step) {
        const dvec2 b = part.points[0].b + e1 * c.x + e2 * c.y;
        const SurfaceJet jet = shape_->jet(part.patch, {b, shape_->texel_at(b)});
        const dvec3 s = frame_.local(jet.s);
        const dvec3 j1 = frame_.turn(jet.s1 * e1.x + jet.s2 * e1.y),
                    j2 = frame_.turn(jet.s1 * e2.x + jet.s2 * e2.y);
        const double det = cross2(dvec2(j1), dvec2(j2));
        const dvec2 change(cross2(dvec2(j2), dvec2(s)) / det, cross2(dvec2(s), dvec2(j1)) / det);
        const double size = std::max(std::abs(change.x), std::abs(change.y));
        if (!std::isfinite(size)) return Root::unknown;
        const double slack = 2 * part.rounding * (glm::length(j1) + glm::length(j2)) / std::abs(det) + 1e-13;
        if (size <= slack || size < 1e-15 || (size < 1e-10 && size >= last_step)) {
            root = {c.x + change.x, c.y + change.y, s.z + j1.z * change.x + j2.z * change.y};
            const bool inside = root.c1 >= -slack && root.c2 >= -slack && root.c1 + root.c2 <= 1 + slack;
            return inside ? Root::inside : Root::outside;
        }
        c += change;
        if (std::abs(c.x) > 4 || std::abs(c.y) > 4) return Root::unknown;
        last_step = size;
    }
    return Root::unknown;
}

void FaceSearch::accept(const Part& part, const LocalRoot& root) {
    if (root.z < z_min_ || root.z > z_max_ || (found_ && root.z == z_max_)) return;
    const dvec2 e1 = part.points[1].b - part.points[0].b, e2 = part.points[2].b - part.points[0].b;
    dvec2 b = glm::max(part.points[0].b + e1 * root.c1 + e2 * root.c2, dvec2(0));
    if (b.x + b.y > 1) b /= b.x + b.y;
    const DomainPoint at{b, shape_->texel_at(b)};
    if (!object_->opaque(at.texel)) return;
    z_max_ = root.z;
    found_ = FoundHit{root.z, shape_, at, part.patch};
}

// The part is flat to within rounding and seen edge-on: the ray is in it between the first and the last place
// of its outline on the ray, and the hit is where that stretch begins, or at z_min.
void FaceSearch::accept_touch(const Part& part) {
    const double radius = 16 * (part.curvature.sag() + part.rounding);
    LocalRoot first{0, 0, std::numeric_limits<double>::max()},
        last{0, 0, std::numeric_limits<double>::lowest()};
    const auto add = [&](std::size_t i, double s) {
        const std::size_t j = (i + 1) % 3;
        std::array<double, 3> c{};
        c[i] = 1 - s;
        c[j] = s;
        const LocalRoot place{c[1], c[2], part.corners[i].z + (part.corners[j].z - part.corners[i].z) * s};
        if (place.z < first.z) first = place;
        if (place.z > last.z) last = place;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec2 from(part.corners[i]), along = dvec2(part.corners[(i + 1) % 3]) - from;
        const double square = glm::dot(along, along), linear = glm::dot(from, along);
        const double rest = glm::dot(from, from) - radius * radius, disc = linear * linear - square * rest;
        double low = 0, high = 1;
        if (square > 0 && disc >= 0) {
            low = std::max(0.0, (-linear - std::sqrt(disc)) / square);
            high = std::min(1.0, (-linear + std::sqrt(disc)) / square);
        } else if (rest > 0) {
            continue;
        }
        if (low > high) continue;
        add(i, low);
        add(i, high);
    }
    if (!(first.z <= last.z) || last.z < z_min_) return;
    if (first.z < z_min_) {
        const double s = (z_min_ - first.z) / (last.z - first.z);
        first = {glm::mix(first.c1, last.c1, s), glm::mix(first.c2, last.c2, s), z_min_};
    }
    accept(part, first);
}

}  // namespace relievo::reference
