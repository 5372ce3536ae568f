// The clone tool's source and its rigid movement.
#include "editor/session/surface/clone_source.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "brushes/tangent_frame.h"

namespace relievo {
namespace {

SurfacePoint surface_point(const MeshSurface& surface, const FacePoint& point) {
    constexpr auto kOne = static_cast<float>(Dab::kBarycentricOne);
    return surface.at(point.face, static_cast<float>(point.b1) / kOne, static_cast<float>(point.b2) / kOne);
}

// The least turn that takes one unit normal to another; half a turn about a tangent where they are opposite.
glm::dquat turn_between(glm::dvec3 from, glm::dvec3 to) {
    constexpr double kOpposite = 1e-9;
    const double scalar = 1.0 + glm::dot(from, to);
    if (scalar < kOpposite) {
        const glm::dvec3 axis = tangent_frame(from).up;
        return {0.0, axis.x, axis.y, axis.z};
    }
    const glm::dvec3 vector = glm::cross(from, to);
    return glm::normalize(glm::dquat(scalar, vector.x, vector.y, vector.z));
}

}  // namespace

void CloneSource::set(const FacePoint& source) {
    source_ = source;
    start_.reset();
    start_before_.reset();
}

void CloneSource::begin(bool aligned) {
    start_before_ = start_;
    if (!aligned) start_.reset();
}

CloneSource::Start CloneSource::start_at(const MeshSurface& surface, const FacePoint& target) const {
    const SurfacePoint to = surface_point(surface, target), from = surface_point(surface, *source_);
    return {glm::dvec3(to.base), glm::dvec3(from.base),
            turn_between(glm::dvec3(to.base_normal), glm::dvec3(from.base_normal))};
}

CloneSource::Place CloneSource::foreseen(const MeshSurface& surface, const FacePoint& target) const {
    const bool first = !start_;
    const Start start = first ? start_at(surface, target) : *start_;
    Place place{};
    if (first) {
        place.point = *source_;
    } else {
        const glm::dvec3 way = glm::dvec3(surface_point(surface, target).base) - start.target;
        place.point = surface.nearest_on_base(start.source + start.turn * way);
    }
    const glm::dvec3 vector(start.turn.x, start.turn.y, start.turn.z);
    for (int k = 0; k < 3; ++k)
        place.turn[static_cast<std::size_t>(k)] =
            static_cast<std::int32_t>(std::lround(vector[k] * Dab::kDragOne));
    return place;
}

CloneSource::Place CloneSource::at(const MeshSurface& surface, const FacePoint& target) {
    const Place place = foreseen(surface, target);
    if (!start_) start_ = start_at(surface, target);
    return place;
}

}  // namespace relievo
