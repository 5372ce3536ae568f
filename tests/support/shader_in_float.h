// The shaders' functions as C++ in float: the arithmetic that ships, over a map in memory. A method's own file is
// included after this one, in a namespace that uses this one.
#pragma once

#include <algorithm>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/integer.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "renderer/height_pyramid.h"
#include "renderer/height_slabs.h"
#include "renderer/primitives.h"
#include "shaders/shared.h"
#include "tests/support/scenes.h"

namespace relievo::shader_in_float {

using glm::abs;
using glm::ceil;
using glm::clamp;
using glm::cross;
using glm::dot;
using glm::findLSB;
using glm::floatBitsToInt;
using glm::floor;
using glm::intBitsToFloat;
using glm::inversesqrt;
using glm::ivec2;
using glm::length;
using glm::log2;
using glm::max;
using glm::min;
using glm::normalize;
using glm::sign;
using glm::sqrt;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using gpu::kPrimitiveFolded;
using gpu::kPrimitiveOpenEdge0;
using gpu::kPrimitiveSearched;
using gpu::kPyramidLevels;
using gpu::kPrimitiveSlanted;
using gpu::kSlantShiftY;
using gpu::kSlantStep;
using gpu::ObjectData;
using gpu::Primitive;
using gpu::PrimitiveNormals;
using uint = std::uint32_t;
using real = float;

// What the shaders' bindings are to the functions below. One subject at a time.
struct Subject {
    const test::TestMap* map = nullptr;
    const HeightPyramid* pyramid = nullptr;
    ObjectData object{};
    PrimitiveNormals normals{};
    std::size_t boxes = 0;  // counted
};
inline Subject subject;

constexpr bool kProcedural = false, kSearch = true, kSlants = true;
inline bool is_procedural(uint) { return false; }
constexpr uint kNoteStep = 0, kNoteRoot = 1, kNoteCell = 2, kNoteHit = 3;
inline void note(uint kind, float, vec2, float, float) {
    subject.boxes += kind == kNoteStep;
}
inline PrimitiveNormals primitive_normals() {
    return subject.normals;
}
inline float pixel_spread() {
    return 1e-3f;
}

inline int wrapped(int x, int size) {
    return subject.object.clamp_wrap != 0 ? std::clamp(x, 0, size - 1) : ((x % size) + size) % size;
}

inline float texel_value(int x, int y) {
    const test::TestMap& map = *subject.map;
    return static_cast<float>(map.texels[static_cast<std::size_t>(wrapped(y, map.height) * map.width +
                                                                  wrapped(x, map.width))]) /
           65535.0f;
}

inline vec4 height_quad(uint, vec2 cell) {
    const int x = static_cast<int>(cell.x), y = static_cast<int>(cell.y);
    return {texel_value(x, y), texel_value(x + 1, y), texel_value(x, y + 1), texel_value(x + 1, y + 1)};
}

// The cell's place in the map, and the node over it.
struct NodeOfCell {
    glm::ivec2 cell, node;
};
inline NodeOfCell node_of_cell(int level, vec2 cell) {
    const HeightPyramid& pyramid = *subject.pyramid;
    const glm::ivec2 at(wrapped(static_cast<int>(std::floor(cell.x)), subject.map->width),
                        wrapped(static_cast<int>(std::floor(cell.y)), subject.map->height));
    return {at, {std::min(at.x >> level, pyramid.width(level) - 1), std::min(at.y >> level, pyramid.height(level) - 1)}};
}

inline vec2 map_bounds(uint, int level, vec2 cell) {
    level = std::min(level, subject.pyramid->levels());
    const glm::ivec2 node = node_of_cell(level, cell).node;
    const HeightPyramid::Node bounds = subject.pyramid->overlapping(level, node.x, node.y);
    return vec2(bounds.low, bounds.high) / 65535.0f;
}

// In the order of their needs.
// clang-format off
#include "shaders/geometry/dialect.glsl"
#include "shaders/geometry/texels.glsl"
#include "shaders/geometry/height.glsl"
#include "shaders/geometry/surface.glsl"
#include "shaders/geometry/prism.glsl"
#include "shaders/geometry/shell.glsl"
#include "shaders/geometry/edges.glsl"
// clang-format on

inline HeightSlab height_slab(uint, int level, vec2 cell) {
    level = std::min(level, subject.pyramid->levels());
    const NodeOfCell at = node_of_cell(level, cell);
    const test::TestMap& map = *subject.map;
    const relievo::PackedSlab packed =
        relievo::height_slab({map.width, map.height, map.texels.data()}, *subject.pyramid, level, at.node.x, at.node.y);
    const vec2 middle = vec2((at.node.x + 1) << level, (at.node.y + 1) << level) - vec2(at.cell);
    return unpacked_slab(vec4(packed.low, packed.high, packed.rise_x, packed.rise_y), level, middle);
}

inline bool opaque_at(Primitive, vec2) {
    return true;
}

}  // namespace relievo::shader_in_float
