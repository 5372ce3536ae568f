// From a reference image to picture files: the layers that it has, over a plain head light (grey by the
// cosine between the normal and the way to the eye), so that the picture can be looked at.
#pragma once

#include <filesystem>
#include <vector>

#include "editor/session/render_output.h"
#include "renderer/reference/reference.h"

namespace relievo {

// As check_render_output; the shading normal is not the reference's to say. Throws std::invalid_argument.
void check_reference_output(const std::filesystem::path& path, const std::vector<Layer>& aovs);

// The head light, 4 linear floats a pixel, alpha = 1 where something is hit.
std::vector<float> head_light(const ReferenceImage& image, const Camera& camera);

// Z, N, uv or id, as Renderer::read_back gives them.
std::vector<float> reference_layer(const ReferenceImage& image, Layer layer);

// A PNG of the head light, or an EXR with it as R G B A and the layers.
void write_reference(const ReferenceImage& image, const Camera& camera, const std::filesystem::path& path,
                     const std::vector<Layer>& aovs);

}  // namespace relievo
