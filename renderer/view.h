// Camera, lights and sky as the shaders read them.
#pragma once

#include "renderer/renderer.h"
#include "shaders/shared.h"

namespace relievo {

// Fills everything but the method's parameters. Positions are rebased by `origin`. At most gpu::kMaxLights lights
// shine; std::invalid_argument beyond.
void fill_view(gpu::FrameData& frame, const Camera& camera, const glm::dvec3& origin, int width, int height);
void fill_lights(gpu::FrameData& frame, const std::vector<Light>& lights, const Environment& environment,
                 const glm::dvec3& origin);

// The unit-direction ray through a pixel position, from the same numbers as the shader's.
Ray ray_through(const gpu::FrameData& frame, double x_px, double y_px);

}  // namespace relievo
