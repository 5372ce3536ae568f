// What geometry/procedural.glsl asks for, on the device: the Gaussianised exemplar stands in the map's place, its pyramid in
// the pyramid's; the table that leads back is read by address (lanes part there: see bvh.glsl).
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#define Source uint

layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer InverseTable { uint pair[]; };

ProceduralData procedural_data(uint object) { return procedural_sources[kObjects == 1u ? 0u : object]; }

// Whole numbers all the way: exact however far the texel lies.
ivec2 exemplar_home(uint object, ivec2 texel) {
    return ivec2((uvec2(texel) + 0x80000000u) % uvec2(object_data(object).map_size));
}

ivec2 exemplar_shift(uint object, uvec2 bits) {
    return ivec2(((bits >> 16u) * uvec2(object_data(object).map_size)) >> 16u);
}

// Both inside the exemplar.
ivec2 shifted_texel(ivec2 home, ivec2 shift, ivec2 size) {
    ivec2 at = home + shift;
    return at - size * ivec2(greaterThanEqual(at, size));
}

vec4 exemplar_quad(uint object, ivec2 home, ivec2 shift) {
    return map_quad(object, vec2(shifted_texel(home, shift, object_data(object).map_size)));
}

float exemplar_value(uint object, ivec2 home, ivec2 shift) {
    ivec2 at = shifted_texel(home, shift, object_data(object).map_size);
    if (kObjects == 1u) return texelFetch(maps[0], at, 0).r;
    return texelFetch(maps[nonuniformEXT(object)], at, 0).r;
}

// For extents of 2^level + 1, as map_bounds asks for them.
vec2 exemplar_bounds(uint object, ivec2 home, ivec2 shift, ivec2 extent) {
    ivec2 size = object_data(object).map_size;
    return pyramid_node(object, size, findMSB(extent.x - 1), shifted_texel(home, shift, size));
}

vec2 inverse_pair(uint object, int i) {
    uint v = InverseTable(procedural_data(object).inverse).pair[i];
    return vec2(float(v & 0xffffu), float(v >> 16)) * (1.0 / 65535.0);
}

#include "../geometry/procedural.glsl"
#include "../geometry/triforce.glsl"
