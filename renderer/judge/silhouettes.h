// Where the reference's image is torn: outlines of the surface, and its inner ones, where a ridge hides what
// lies behind.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/judge/error_units.h"
#include "renderer/reference/reference.h"

namespace relievo {

// One flag a pixel: within `reach` pixels of it, the reference hits and misses, or its depth leaves the
// tangent plane of a neighbour's hit by more than 0.2 of its object's unit.
std::vector<std::uint8_t> find_silhouettes(const ReferenceImage& image, const Camera& camera,
                                           const glm::dvec3& scene_origin, std::span<const ErrorUnit> units,
                                           int reach);

}  // namespace relievo
