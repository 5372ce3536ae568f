// Small functions that geometry/ and methods/ share.
#ifndef RELIEVO_DIALECT_GLSL
#define RELIEVO_DIALECT_GLSL
#include "macros.glsl"

FUNC float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Whole numbers from 0 to 2^23 - 1 as integers, by the bits of a float that has no room for a fraction.
FUNC ivec2 whole(vec2 x) { return floatBitsToInt(x + vec2(8388608.0f)) & 0x7fffff; }

// The same from -2^22 to 2^22 - 1.
FUNC ivec2 signed_whole(vec2 x) { return floatBitsToInt(x + vec2(12582912.0f)) - 0x4b400000; }

// 2^n for whole n from -126 to 127.
FUNC float power_of_two(int n) { return intBitsToFloat((n + 127) << 23); }

// Where a ray met the surface of one triangle.
struct SurfaceHit {
    float t;  // ray parameter
    vec2 b;   // barycentrics of vertices 1 and 2
};

// Bounds of a map's heights about a plane over the texels asked for, which begin with the cell `from`:
// height - dot(slope, texel - from - middle) lies within `bounds`.
struct HeightSlab {
    vec2 bounds;
    vec2 slope;   // per texel
    vec2 middle;  // texels, from `from`
};

// Of a node as renderer/height_slabs.h packs it: low, high and the two rises.
FUNC HeightSlab unpacked_slab(vec4 node, int level, vec2 middle) {
    HeightSlab slab;
    slab.bounds = (vec2(node.x, node.y) + 32768.0f) * (1.0f / 65535.0f);
    slab.slope = vec2(node.z, node.w) * (power_of_two(-level) * (1.0f / 65535.0f));
    slab.middle = middle;
    return slab;
}
#endif
