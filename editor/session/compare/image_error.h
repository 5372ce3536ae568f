// How far one beauty lies from another.
#pragma once

#include <span>

#include "editor/session/compare/result.h"

namespace relievo {

// 4 linear floats a pixel, as Renderer::read_back gives them; equal sizes.
//
// The perceptual measure is the structural similarity of Wang and others 2004 (Gaussian window of
// deviation 1.5, K1 0.01, K2 0.03) over the luma that a display shows. OpenImageIO's compare_Yee was tried
// first: as Debian 12 packages it (2.4.7), it tells colours apart but no brightness, not even black from
// white.
ImageError image_error(int width, int height, std::span<const float> beauty, std::span<const float> truth);

}  // namespace relievo
