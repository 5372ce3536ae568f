// Texel space and bilinear taps, as DESIGN.md section 1 defines them.
// Texel space has texel (i, j)'s centre at the integer point (i, j): X = u * W - 1/2, Y = v * H - 1/2.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

#include "renderer/scene/scene.h"

namespace relievo {

// Size and wrap of a map: all that its texture layout depends on.
struct MapGrid {
    int width, height;
    Wrap wrap;

    glm::dvec2 texel_from_uv(glm::vec2 uv) const {
        return {static_cast<double>(uv.x) * width - 0.5, static_cast<double>(uv.y) * height - 0.5};
    }

    static std::int64_t wrapped(std::int64_t i, std::int64_t size) {
        const std::int64_t r = i % size;
        return r < 0 ? r + size : r;
    }

    // The texel that stands at the integer point (x, y) once the wrap is applied: y * width + x.
    std::uint32_t index(std::int64_t x, std::int64_t y) const {
        if (wrap == Wrap::repeat) {
            x = wrapped(x, width);
            y = wrapped(y, height);
        } else {
            x = std::clamp<std::int64_t>(x, 0, width - 1);
            y = std::clamp<std::int64_t>(y, 0, height - 1);
        }
        return static_cast<std::uint32_t>(y * width + x);
    }
};

// The four texels of one bilinear sample; tap order (x0,y0), (x1,y0), (x0,y1), (x1,y1).
struct BilinearTaps {
    std::array<std::uint32_t, 4> texel;
    double fx, fy;  // [0, 1)

    std::array<double, 4> weights() const {
        return {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy};
    }
};

inline BilinearTaps bilinear_taps(const MapGrid& grid, glm::dvec2 p) {
    const double x = std::floor(p.x), y = std::floor(p.y);
    const auto i = static_cast<std::int64_t>(x), j = static_cast<std::int64_t>(y);
    return {{grid.index(i, j), grid.index(i + 1, j), grid.index(i, j + 1), grid.index(i + 1, j + 1)},
            p.x - x,
            p.y - y};
}

// Height in counts, [0, 65535].
inline double bilinear(std::span<const std::uint16_t> texels, const BilinearTaps& taps) {
    const auto w = taps.weights();
    return w[0] * texels[taps.texel[0]] + w[1] * texels[taps.texel[1]] + w[2] * texels[taps.texel[2]] +
           w[3] * texels[taps.texel[3]];
}

}  // namespace relievo
