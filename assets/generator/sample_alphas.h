// Images for the stamp tool, so that an artist has some at once.
#pragma once

#include <span>

namespace relievo::assets {

// `value`: [0, 1] at a place of [-1, 1]^2, y up; 0 at the border, so that no edge is stamped.
struct SampleAlpha {
    const char* name;
    double (*value)(double x, double y);
};
std::span<const SampleAlpha> sample_alphas();

inline constexpr int kAlphaSize = 256;  // pixels a side

}  // namespace relievo::assets
