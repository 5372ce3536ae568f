// The inside of evaluate.h, for one precision: what procedural.glsl asks of its including side, then itself.
// No guard.
using glm::abs;
using glm::clamp;
using glm::dot;
using glm::findMSB;
using glm::floor;
using glm::ivec2;
using glm::max;
using glm::min;
using glm::sqrt;
using glm::uaddCarry;
using glm::umulExtended;
using glm::uvec2;
using glm::uvec3;
using gpu::kInverseSize;
using gpu::kPyramidLevels;
using gpu::ProceduralData;
using uint = std::uint32_t;
using Source = const ExemplarView&;

inline ProceduralData procedural_data(Source e) {
    return e.data;
}
inline ivec2 exemplar_home(Source e, ivec2 texel) {
    return wrapped_texel(e, texel);
}
inline ivec2 exemplar_shift(Source e, uvec2 bits) {
    return random_shift(e, bits);
}

inline real exemplar_value(Source e, ivec2 home, ivec2 shift) {
    const ivec2 at = shifted_texel(e, home, shift);
    return static_cast<real>(e.texels[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(e.width) +
                                      static_cast<std::size_t>(at.x)]) /
           real(65535);
}

inline vec4 exemplar_quad(Source e, ivec2 home, ivec2 shift) {
    return {exemplar_value(e, home, shift), exemplar_value(e, home, shift + ivec2(1, 0)),
            exemplar_value(e, home, shift + ivec2(0, 1)), exemplar_value(e, home, shift + ivec2(1, 1))};
}

inline vec2 exemplar_bounds(Source e, ivec2 home, ivec2 shift, ivec2 extent) {
    const ivec2 at = shifted_texel(e, home, shift);
    const ExemplarBounds::Range range = e.bounds->range(at.x, at.y, extent.x + 1, extent.y + 1);
    return vec2(range.low, range.high) / real(65535);
}

inline vec2 inverse_pair(Source e, int i) {
    return vec2(e.inverse[i] & 0xffffu, e.inverse[i] >> 16) / real(65535);
}

#include "shaders/geometry/macros.glsl"
#include "shaders/geometry/hash.glsl"
#include "shaders/geometry/procedural.glsl"
#include "shaders/geometry/triforce.glsl"
