// The clone tool: relief from elsewhere. Places are compared on the base mesh, in the planes across the base
// normal at the dab's centre and at its source, so that texture islands and their scales do not matter.
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "brushes/dab_work.h"
#include "brushes/relief.h"
#include "brushes/tangent_frame.h"

namespace relievo {
namespace {

glm::dvec3 turned(glm::dvec3 direction, glm::dvec3 vector_part) {
    const double square = std::min(glm::dot(vector_part, vector_part), 1.0);
    return glm::dquat(std::sqrt(1.0 - square), vector_part.x, vector_part.y, vector_part.z) * direction;
}

}  // namespace

void clone(const Work& work) {
    const SurfacePoint& target = work.place.centre;
    const SurfacePoint& source = *work.place.source;
    const TangentFrame there = tangent_frame(target.base_normal);
    const TangentFrame here =
        tangent_frame(source.base_normal, turned(there.right, glm::dvec3(work.place.hand)));
    const Relief relief(work, source, work.place.radius);
    in_trail(work, [&](const Work& part, const SurfaceTexel& texel) {
        const float weight = part.weight(texel);
        if (weight == 0.0f || !(glm::dot(texel.normal, target.base_normal) > 0.0f)) return;
        const glm::dvec3 offset = glm::dvec3(base_of(part, texel)) - glm::dvec3(target.base);
        const glm::dvec3 place = glm::dvec3(source.base) + glm::dot(offset, there.right) * here.right +
                                 glm::dot(offset, there.up) * here.up;
        const auto value = relief.at(glm::vec3(place), source.base_normal);
        if (!value) return;
        const float before = static_cast<float>(part.stroke.before(texel.x, texel.y));
        const float change = (static_cast<float>(*value) - before) * weight;
        if (std::abs(change) > std::abs(part.change(texel))) part.change_to(texel, change);
    });
}

}  // namespace relievo
