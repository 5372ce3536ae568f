// Moments in cells, planes through them, and upwind differences; see the header.
#include "brushes/broad_slope.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "brushes/dab_work.h"
#include "brushes/relief.h"
#include "brushes/tangent_frame.h"
#include "brushes/texel_spacing.h"

namespace relievo {
namespace {

constexpr double kOfRadius = 0.25;  // a cell's width
constexpr double kTexels = 3.0;     // of it at least: fewer, and the texels' grid shows in the sums
constexpr double kUpwind = 0.5;     // cells
constexpr int kHalf = 8;            // corners either way of the centre: twice the reach
constexpr int kAcross = 2 * kHalf + 1;
constexpr int kSides = 6;
constexpr std::uint32_t kNone = ~std::uint32_t{0};
constexpr double kLeast = 1e-9;  // of weights: without weight, a corner has no plane

bool is_inside(glm::dvec3 place) {
    return std::abs(place.x) <= kHalf && std::abs(place.y) <= kHalf && std::abs(place.z) <= kHalf;
}

std::size_t index_of(glm::dvec3 corner, int side) {
    const auto from_low = [](double at) { return static_cast<std::size_t>(static_cast<int>(at) + kHalf); };
    return ((static_cast<std::size_t>(side) * kAcross + from_low(corner.z)) * kAcross + from_low(corner.y)) *
               kAcross +
           from_low(corner.x);
}

// Calls visit(corner, its index, weight) for the corners around a place.
template <typename Visit>
void visit_corners(glm::dvec3 place, int side, const Visit& visit) {
    const glm::dvec3 low = glm::floor(place), part = place - low;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 step(i & 1, i >> 1 & 1, i >> 2);
        const glm::dvec3 near = step * part + (1.0 - step) * (1.0 - part);
        const double weight = near.x * near.y * near.z;
        const glm::dvec3 corner = low + step;
        if (weight > kLeast && is_inside(corner)) visit(corner, index_of(corner, side), weight);
    }
}

// Calls visit(side, weight) for the sides that the normal leans to.
template <typename Visit>
void visit_sides(glm::vec3 normal, const Visit& visit) {
    for (int axis = 0; axis < 3; ++axis) {
        const double lean = double{normal[axis]} * double{normal[axis]};
        if (lean > kLeast) visit(2 * axis + (normal[axis] < 0.0f ? 1 : 0), lean);
    }
}

}  // namespace

BroadSlope::BroadSlope(const Work& work, float reach, bool up) : centre_(work.place.centre.base) {
    constexpr std::size_t kFewTexels = 24;
    const glm::vec3 centre = work.place.centre.position, facing = work.place.centre.base_normal;
    TexelSpacing spacing(0);
    for (int doubled = 0; doubled <= 4 && spacing.texels() < kFewTexels; ++doubled) {
        if (doubled > 0) reach *= 2.0f;
        spacing = TexelSpacing(double{reach});
        work.surface.visit_ball(centre, reach, [&](std::span<const SurfaceTexel> part) {
            for (const SurfaceTexel& t : part)
                if (glm::dot(t.normal, facing) > 0.0f) spacing.add(t, base_of(work, t));
        });
    }
    corner_at_.assign(std::size_t{kSides} * kAcross * kAcross * kAcross, kNone);
    if (spacing.texels() == 0) return;
    const double radius_in_texels = double{work.place.radius} / spacing.by_area();
    cell_ = spacing.value() * std::max(kTexels, kOfRadius * radius_in_texels);
    work.surface.visit_ball(centre, reach, [&](std::span<const SurfaceTexel> part) {
        for (const SurfaceTexel& t : part) add(base_of(work, t), t.normal, double{work.value(t)});
    });
    for (Corner& corner : corners_) fit_plane(corner);
    for (Corner& corner : corners_) corner.slope = upwind_slope(corner, up);
}

void BroadSlope::add(glm::vec3 base, glm::vec3 normal, double value) {
    const glm::dvec3 place = (glm::dvec3(base) - centre_) / cell_;
    if (!is_inside(place)) return;
    const glm::dmat3 square = glm::outerProduct(place, place);
    visit_sides(normal, [&](int side, double lean) {
        visit_corners(place, side, [&](glm::dvec3 at, std::size_t index, double part) {
            std::uint32_t& found = corner_at_[index];
            if (found == kNone) {
                found = static_cast<std::uint32_t>(corners_.size());
                corners_.push_back({at, side});
            }
            Corner& corner = corners_[found];
            const double weight = lean * part;
            corner.weight += weight;
            corner.value += weight * value;
            corner.normal += weight * glm::dvec3(normal);
            corner.place += weight * place;
            corner.place_value += weight * value * place;
            corner.place_place += weight * square;
        });
    });
}

void BroadSlope::fit_plane(Corner& corner) const {
    const glm::dvec3 mean = corner.place / corner.weight;
    const glm::dmat3 spread = corner.place_place / corner.weight - glm::outerProduct(mean, mean);
    const glm::dvec3 rise = corner.place_value / corner.weight - mean * (corner.value / corner.weight);
    corner.normal = glm::normalize(corner.normal);  // not zero: they all lean to the side
    const TangentFrame frame = tangent_frame(corner.normal);
    constexpr double kRidge = 1e-4;  // settles texels along a line
    const double uu = glm::dot(frame.right, spread * frame.right) + kRidge,
                 vv = glm::dot(frame.up, spread * frame.up) + kRidge,
                 uv = glm::dot(frame.right, spread * frame.up), ru = glm::dot(rise, frame.right),
                 rv = glm::dot(rise, frame.up);
    const double determinant = uu * vv - uv * uv;
    corner.gradient = ((ru * vv - rv * uv) * frame.right + (rv * uu - ru * uv) * frame.up) / determinant;
}

glm::dvec3 BroadSlope::gradient(glm::dvec3 place, int side) const {
    glm::dvec3 sum(0);
    double total = 0;
    visit_corners(place, side, [&](glm::dvec3, std::size_t index, double part) {
        const std::uint32_t found = corner_at_[index];
        if (found == kNone) return;
        const double weight = part * corners_[found].weight;
        sum += weight * corners_[found].gradient;
        total += weight;
    });
    return sum / total;
}

double BroadSlope::upwind_slope(const Corner& corner, bool up) const {
    const TangentFrame frame = tangent_frame(corner.normal);
    const auto along = [&](glm::dvec3 way) {
        const double ahead = glm::dot(gradient(corner.at + kUpwind * way, corner.side), way),
                     behind = glm::dot(gradient(corner.at - kUpwind * way, corner.side), way);
        return up ? std::max({ahead, -behind, 0.0}) : std::max({-ahead, behind, 0.0});
    };
    return std::hypot(along(frame.right), along(frame.up));
}

double BroadSlope::at(glm::vec3 base, glm::vec3 normal) const {
    const glm::dvec3 place = (glm::dvec3(base) - centre_) / cell_;
    if (!is_inside(place)) return 0.0;
    double sum = 0, total = 0;
    visit_sides(normal, [&](int side, double lean) {
        visit_corners(place, side, [&](glm::dvec3, std::size_t index, double part) {
            const std::uint32_t found = corner_at_[index];
            if (found == kNone) return;
            const double weight = lean * part * corners_[found].weight;
            sum += weight * corners_[found].slope;
            total += weight;
        });
    });
    return total > 0.0 ? sum / (total * cell_) : 0.0;
}

}  // namespace relievo
