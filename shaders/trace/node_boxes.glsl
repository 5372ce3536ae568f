// What the two walks through the program's own tree of boxes share (renderer/wide_bvh.h): a node's boxes as numbers.
const float kNotMet = 1e38;

vec4 bytes_of(uint v) {
    return vec4(float(v & 255u), float((v >> 8) & 255u), float((v >> 16) & 255u), float(v >> 24));
}

// World units of a step of a node's boxes along each axis.
vec3 steps_of(uint exponents) {
    return uintBitsToFloat(uvec3(exponents << 23, exponents << 15, exponents << 7) & 0x7f800000u);
}

vec3 inverse_of(vec3 direction) { return 1.0 / mix(direction, vec3(1e-20), lessThan(abs(direction), vec3(1e-20))); }

// The least and the greatest of distances as integers, for which processors have one instruction: for floats it is three,
// because of NaN. Right where the result is not negative; of several negative ones any may come.
float earliest(float a, float b) { return intBitsToFloat(min(floatBitsToInt(a), floatBitsToInt(b))); }
float latest(float a, float b) { return intBitsToFloat(max(floatBitsToInt(a), floatBitsToInt(b))); }
vec4 earliest(vec4 a, vec4 b) { return intBitsToFloat(min(floatBitsToInt(a), floatBitsToInt(b))); }
vec4 latest(vec4 a, vec4 b) { return intBitsToFloat(max(floatBitsToInt(a), floatBitsToInt(b))); }

// A box is met between the entry, at least t_min and so not negative, and the way out. Eight units in the last place pay for
// the rounding of far boxes, the boxes' own slack for that of near ones.
const float kLeaveSlack = 1.000001;
