// Where a point of the scene stands in the picture: for the live window around the brush.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "renderer/renderer.h"

namespace relievo {

// Pixel position (0..width, 0..height; row 0 at the top) of a rebased point (world minus `origin`); empty
// behind the eye. May lie outside the picture.
std::optional<glm::dvec2> project(const Camera& camera, const glm::dvec3& origin, int width, int height,
                                  const glm::vec3& point);

// The window of `size` x `size` pixels around a pixel position, moved (not cut) so that it lies in the
// picture.
PixelRect window_around(const glm::dvec2& centre_px, int size, int width, int height);

}  // namespace relievo
