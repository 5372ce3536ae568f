// What the two walks through the program's own tree of boxes share (renderer/wide_bvh.h): a node's boxes as numbers.
const float kNotMet = 1e38;

vec4 bytes_of(uint v) {
    return vec4(float(v & 255u), float((v >> 8) & 255u), float((v >> 16) & 255u), float(v >> 24));
}

// World units of a step of a node's boxes along each axis.
vec3 steps_of(uint exponents) {
    uvec3 below = uvec3(exponents >> 8, exponents >> 12, exponents >> 16) & 15u;
    return uintBitsToFloat((uvec3(exponents & 255u) - below) << 23);
}

// Across the surface that a node holds; multiples of 1/32, so that renderer/wide_bvh.cpp has the same.
vec3 slab_direction(uint exponents) {
    uint code = exponents >> 20;
    float u = float(code & 31u) * 0.0625 - 0.96875, v = float((code >> 5) & 31u) * 0.0625 - 0.96875;
    return code < 1024u ? vec3(1.0, u, v) : code < 2048u ? vec3(v, 1.0, u) : vec3(u, v, 1.0);
}

// A slab's bound of k steps is met at k step + enter, if it is the first, and at k step + leave, if it is the last.
struct Slab {
    float step, enter, leave;
};

// Along a fourth direction the ray's own is not a number as it stands but a sum, whose rounding nearly parallel rays make
// large: a millionth of the distances pays for it. `steps` and `away` are those of the node's boxes, from the ray's origin.
Slab slab_of(uint exponents, vec3 steps, vec3 away, vec3 direction) {
    Slab s;
    vec3 across = slab_direction(exponents);
    float along = dot(across, direction), inverse = 1.0 / (abs(along) < 1e-20 ? 1e-20 : along);
    float width = dot(abs(across), steps);
    float start = dot(across, away) + 255.0 * dot(min(across, vec3(0.0)), steps);
    float rounding = (dot(abs(across), abs(away)) + 255.0 * width) * abs(inverse) * 1e-6;
    bool told = exponents < kBvhNoSlab << 20;
    s.step = told ? width * inverse : 0.0;
    s.enter = told ? start * inverse - rounding : -kNotMet;
    s.leave = told ? start * inverse + rounding : 0.5 * kNotMet;
    return s;
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
