// Depth errors as a picture: log scale, misses and inventions marked.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "editor/session/image_file.h"
#include "renderer/judge/judge.h"

namespace relievo {

using Rgb = std::array<std::uint8_t, 3>;

// The scale's ends, in the object's unit; what lies beyond takes the end's colour.
constexpr double kErrorMapLow = 1e-6, kErrorMapHigh = 1;
constexpr Rgb kMissedColor{255, 0, 200}, kInventedColor{0, 230, 255}, kNothingColor{38, 40, 46};

Rgb error_color(double error);  // of a depth error, over the unit
DisplayPicture error_map(int width, int height, const std::vector<Judge::PixelError>& errors);

}  // namespace relievo
