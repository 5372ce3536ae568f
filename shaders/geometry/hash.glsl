// Counter-based random bits: a hash of what is being asked for, never a running state.
#ifndef RELIEVO_HASH_GLSL
#define RELIEVO_HASH_GLSL

// pcg3d, Jarzynski and Olano 2020.
FUNC uvec3 pcg3d(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

#endif
