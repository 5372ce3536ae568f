// One face's footprint in texel space, row by row: which texel centres it holds, its border included.
// A crossing is computed from the edge's ends in one fixed order, so that two faces with the same edge get
// the same number: a texel centre on or beside a shared edge is in at least one of the two.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat2x3.hpp>
#include <glm/vec2.hpp>
#include <optional>

#include "editor/session/surface/texel_sampling.h"
#include "renderer/scene/mesh.h"

namespace relievo {

struct TexelSpan {
    std::int64_t first, last;  // closed; before the wrap is applied
};

struct TexelTriangle {
    std::array<glm::dvec2, 3> p;  // texel space

    // Rows whose centres the triangle reaches; empty (first > last) where there are none.
    TexelSpan rows() const;
    // The columns of texel centres in row y. Requires y in rows().
    TexelSpan columns(std::int64_t y) const;
    // Twice the signed area in texels; 0 for a degenerate footprint.
    double doubled_area() const;
};

TexelTriangle texel_triangle(const Mesh& mesh, std::uint32_t face, const MapGrid& grid);

// A footprint can be rasterised unless it is degenerate or repeats the map more than 64 times a side.
bool can_rasterise(const TexelTriangle& triangle, const MapGrid& grid);

// Columns: the step in space, on the base triangle, of one texel right and of one texel up. Requires a footprint that is
// not degenerate.
glm::dmat2x3 space_from_texels(const Mesh& mesh, std::uint32_t face, const TexelTriangle& triangle);

// The span's part that exists in the map: all of it under repeat, the part in [0, size) under clamp.
TexelSpan clipped(TexelSpan span, int size, Wrap wrap);

}  // namespace relievo
