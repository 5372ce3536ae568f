// The common tongue of GLSL and C++ (GLM): geometry/ and methods/ are compiled as both, so that the arithmetic that
// ships can be run under sanitizers and against double precision. No swizzles, no GLSL-only built-ins.
#ifndef RELIEVO_DIALECT_GLSL
#define RELIEVO_DIALECT_GLSL
#ifdef __cplusplus
#define OUT(T) T&
#define INOUT(T) T&
#define FUNC inline
#else
#define OUT(T) out T
#define INOUT(T) inout T
#define FUNC
#endif

FUNC float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Whole numbers from 0 to 2^23 - 1 as integers, by the bits of a float that has no room for a fraction.
FUNC ivec2 whole(vec2 x) { return floatBitsToInt(x + vec2(8388608.0f)) & 0x7fffff; }

// 2^n for whole n from -126 to 127.
FUNC float power_of_two(int n) { return intBitsToFloat((n + 127) << 23); }

// Where a ray met the surface of one triangle.
struct SurfaceHit {
    float t;  // ray parameter
    vec2 b;   // barycentrics of vertices 1 and 2
};
#endif
