// Base triangles as rays meet them: prism in the triangle's frame, texture footprint, height range.
// Paper 002, section 4 (parallel offset prism, equations 4 to 6) and 5.4 (extents per prism).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/procedural/procedural_source.h"
#include "renderer/scene/mesh.h"
#include "shaders/shared.h"

namespace relievo {

struct Box {
    glm::vec3 low, high;  // world
    bool operator==(const Box&) const = default;
};

// Displacement of one triangle's surface, world units along the interpolated unit normal.
struct DisplacementRange {
    double low, high;
    bool operator==(const DisplacementRange&) const = default;
};

// The vertex normals' cosines to ng are held above this: beyond, the parallel offset prism runs to infinity.
constexpr double kLeastNormalCosine = 0.05;

struct MapSize {
    int width, height;
};

// How texture coordinates become texels.
struct TexelSpace {
    MapSize size;
    bool clamp = false;
    const ProceduralSource* source = nullptr;  // procedural heights: its virtual texels, without wrap
};

// Everything but heights. Nothing for a triangle without area or with numbers that are not finite: S has no inside
// there. Texel coordinates are kept relative to an integer base, so that 16384 texels leave all fraction bits.
std::optional<gpu::Primitive> make_primitive(const Mesh& mesh, std::uint32_t face, std::uint32_t object,
                                             const TexelSpace& texels);
gpu::PrimitiveNormals primitive_normals(const Mesh& mesh, std::uint32_t face);

// Sets w_low, w_high and the folded flag so that the prism holds the surface. Conservative.
void set_heights(gpu::Primitive& primitive, const DisplacementRange& range);
// For methods that meet S itself, in set_heights' stead: S is displaced along N(b), the parallel prism along
// sum b_i N_i/(N_i.Ng), and the two differ by at most the shell margin. Where that is large, or the shell folds, the
// primitive is flagged kPrimitiveSearched and its heights are the range itself.
void set_shell(gpu::Primitive& primitive, const gpu::PrimitiveNormals& normals, const DisplacementRange& range);

// How far beside a surface its hits may be found: of its size, and of its coordinates.
constexpr float kRoundingOfSize = 2e-5f, kRoundingOfCoordinates = 1e-6f;
// The box, a little larger than rounding needs.
Box with_rounding(const Box& box);

// Order in which primitives are stored: recursive median split over the boxes' centres, because some drivers only
// halve the index range (measured on lavapipe: rays 1.1 to 7 times faster).
std::vector<std::uint32_t> spatial_order(const std::vector<Box>& boxes);

}  // namespace relievo
