// shaders/geometry/procedural.glsl and triforce.glsl as C++: in double for the processor (namespace procedural_double), and in
// float, the arithmetic that ships to the device (procedural_float).
#pragma once

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/integer.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "renderer/procedural/exemplar_bounds.h"
#include "shaders/shared.h"

namespace relievo {

// What the functions read. Everything pointed to outlives them.
struct ExemplarView {
    gpu::ProceduralData data;
    int width = 0, height = 0;
    const std::uint16_t* texels = nullptr;   // Gaussianised
    const std::uint32_t* inverse = nullptr;  // gpu::kInverseSize pairs
    const ExemplarBounds* bounds = nullptr;
};

// The exemplar's own texel under a virtual one: shared by both precisions, as bits are.
inline glm::ivec2 wrapped_texel(const ExemplarView& e, const glm::ivec2& texel) {
    const glm::uvec2 biased = glm::uvec2(texel) + 0x80000000u;
    return {static_cast<int>(biased.x % static_cast<unsigned>(e.width)),
            static_cast<int>(biased.y % static_cast<unsigned>(e.height))};
}

inline glm::ivec2 random_shift(const ExemplarView& e, const glm::uvec2& bits) {
    return {static_cast<int>(((bits.x >> 16) * static_cast<unsigned>(e.width)) >> 16),
            static_cast<int>(((bits.y >> 16) * static_cast<unsigned>(e.height)) >> 16)};
}

inline glm::ivec2 shifted_texel(const ExemplarView& e, const glm::ivec2& home, const glm::ivec2& shift) {
    return {(home.x + shift.x) % e.width, (home.y + shift.y) % e.height};
}

}  // namespace relievo

namespace relievo::procedural_double {
using real = double;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;
#include "renderer/procedural/evaluate_body.h"
}  // namespace relievo::procedural_double

#undef RELIEVO_HASH_GLSL
#undef RELIEVO_PROCEDURAL_GLSL
#undef RELIEVO_TRIFORCE_GLSL

namespace relievo::procedural_float {
using real = float;
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using vec4 = glm::vec4;
#include "renderer/procedural/evaluate_body.h"
}  // namespace relievo::procedural_float

// Headers that follow name template parameters so.
#undef RELIEVO_MACROS_GLSL
#undef OUT
#undef INOUT
#undef FUNC
