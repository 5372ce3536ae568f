// The triforce of thesis 000, section 5.4: a half of a lattice square of a procedural height source, divided again and again
// into four alike, walked without a stack, and bounds of the heights over a part. GLSL, C++ in float and in double.
//
// Deviations from the thesis:
//  - the source's heights are bilinear between virtual texels (procedural.glsl), so a height within a texel of the
//    lattice's edges is made of texels of the next triangle too: bounds are widened there by what those may weigh;
//  - the denominator is bounded as a norm, convex in the weights, instead of by affine arithmetic (equation 5.14);
//  - four exemplar values are not needed for an exemplar's range: nodes of its pyramid overlap (exemplar_bounds);
//  - parts are visited in the order of the ray.
#ifndef RELIEVO_TRIFORCE_GLSL
#define RELIEVO_TRIFORCE_GLSL

// A part, in units of 1/range of the lattice square (equations 5.5 to 5.7): its right angle at `base`, its other corners
// `size` further along each axis. Parts that stand on their heads have a negative size.
struct Triforce {
    ivec2 base;
    int size;
};

// Part 3 is the one in the middle.
FUNC ivec2 part_place(int part) { return ivec2(part >> 1, part & 1); }

FUNC Triforce part_of(ivec2 base, int half_size, int part) {
    Triforce t;
    t.base = base + part_place(part) * half_size;
    t.size = part == 3 ? -half_size : half_size;
    return t;
}

// The parts' numbers, two bits each, by how far their middles lie along `direction` in lattice space. Parts of a triangle
// on its head come in the opposite order.
FUNC int part_order(vec2 direction) {
    int order = 0;
    for (int i = 0; i < 4; ++i) {
        int rank = 0;
        for (int j = 0; j < 4; ++j) {
            ivec2 a = part_place(i), b = part_place(j);
            // Thirds of a half: right angle, and a third of the part's own size further; the middle part lies at (2, 2).
            vec2 at = i == 3 ? vec2(2.0f, 2.0f) : vec2(real(3 * a.x + 1), real(3 * a.y + 1));
            vec2 other = j == 3 ? vec2(2.0f, 2.0f) : vec2(real(3 * b.x + 1), real(3 * b.y + 1));
            real ahead = dot(at - other, direction);
            if (ahead > real(0.0f) || (ahead == real(0.0f) && j < i)) ++rank;
        }
        order |= i << (2 * rank);
    }
    return order;
}

FUNC Triforce triforce_down(Triforce t, int order) {
    return part_of(t.base, t.size / 2, t.size > 0 ? order & 3 : (order >> 6) & 3);
}

// The next part, after as many steps up as it takes. False when all of the half has been visited.
FUNC bool triforce_next(int order, int range, INOUT(Triforce) t) {
    while (abs(t.size) < range) {
        int log_size = findMSB(abs(t.size));
        int part = 2 * ((t.base.x >> log_size) & 1) + ((t.base.y >> log_size) & 1);
        int half_size = part == 3 ? -t.size : t.size;
        ivec2 base = t.base - part_place(part) * half_size;
        int rank = 0;
        for (int i = 1; i < 4; ++i)
            if (((order >> (2 * i)) & 3) == part) rank = i;
        int next = half_size > 0 ? rank + 1 : rank - 1;
        if (next >= 0 && next < 4) {
            t = part_of(base, half_size, (order >> (2 * next)) & 3);
            return true;
        }
        t.base = base;
        t.size = 2 * half_size;
    }
    return false;
}

// Lattice space near a virtual texel: coordinates relative to the corner of that texel's lattice square.
struct LatticeMap {
    ivec2 texel, square;
    vec2 f;                     // lattice coordinates of the texel
    real up_x, across_y, up_y;  // change of the coordinates per texel, as in ProceduralData
};

FUNC LatticeMap lattice_map(ProceduralData data, ivec2 texel) {
    LatticeMap m;
    uvec2 x, y;
    lattice_coordinates(data, texel, x, y);
    LatticePlace place = lattice_place(x, y);
    m.texel = texel;
    m.square = place.square;
    m.f = place.f;
    m.up_x = fixed_real(data.step_xy);
    m.across_y = fixed_real(data.step_yx);
    m.up_y = fixed_real(data.step_yy);
    return m;
}

// Texels are relative to the map's.
FUNC vec2 to_lattice(LatticeMap m, vec2 texel) {
    return vec2(m.f.x + m.up_x * texel.y, m.f.y + m.across_y * texel.x + m.up_y * texel.y);
}

FUNC vec2 to_texels(LatticeMap m, vec2 place) {
    real y = (place.x - m.f.x) / m.up_x;
    return vec2((place.y - m.f.y - m.up_y * y) / m.across_y, y);
}

// Half of the lattice square at `square` (relative to the map's), `beyond` the diagonal or not, and the exemplar's offsets at
// its vertices: the same for all of its parts.
struct LatticeHalf {
    ivec2 square;
    bool beyond;
    ivec2 shift0, shift1, shift2;
};

FUNC LatticeHalf lattice_half(Source object, ProceduralData data, LatticeMap m, ivec2 square, bool beyond) {
    LatticeHalf h;
    h.square = square;
    h.beyond = beyond;
    h.shift0 = vertex_shift(object, data.seed, lattice_vertex(m.square + square, beyond, 0));
    h.shift1 = vertex_shift(object, data.seed, lattice_vertex(m.square + square, beyond, 1));
    h.shift2 = vertex_shift(object, data.seed, lattice_vertex(m.square + square, beyond, 2));
    return h;
}

// Least and greatest height, in [0, 1], over a part of the half: the right angle at `base`, 0 to 1 within the square, the other
// corners `size` further.
FUNC vec2 triforce_bounds(Source object, ProceduralData data, LatticeMap m, LatticeHalf half_square, vec2 base, real size) {
    bool beyond = half_square.beyond;
    ivec2 square = half_square.square;
    vec2 corner = vec2(real(square.x), real(square.y));
    vec2 t0 = to_texels(m, corner + base), t1 = to_texels(m, corner + base + vec2(size, 0.0f)),
         t2 = to_texels(m, corner + base + vec2(0.0f, size));
    vec2 low_texel = floor(min(t0, min(t1, t2)) - vec2(real(2e-3f))), high_texel = floor(max(t0, max(t1, t2)) + vec2(real(2e-3f)));
    ivec2 first = ivec2(int(low_texel.x), int(low_texel.y));
    ivec2 reach = ivec2(int(high_texel.x), int(high_texel.y)) + ivec2(1, 1) - first;
    int needed = max(reach.x, reach.y), level = needed <= 3 ? 1 : findMSB(needed - 2) + 1;
    if (level > kPyramidLevels) return vec2(real(data.range.x), real(data.range.y));
    ivec2 home = exemplar_home(object, m.texel + first);
    vec3 low = vec3(0.0f), high = vec3(0.0f);
    for (int i = 0; i < 3; ++i) {
        ivec2 shift = i == 0 ? half_square.shift0 : (i == 1 ? half_square.shift1 : half_square.shift2);
        vec2 range = exemplar_bounds(object, home, shift, ivec2((1 << level) + 1));
        low[i] = range.x;
        high[i] = range.y;
    }
    real least_value = min(low.x, min(low.y, low.z)), most_value = max(high.x, max(high.y, high.z));
    // The numerator is linear in the weights: its bounds are at the corners (5.8 to 5.10). |w| is convex.
    vec3 w0 = lattice_weights(base, beyond), w1 = lattice_weights(base + vec2(size, 0.0f), beyond),
         w2 = lattice_weights(base + vec2(0.0f, size), beyond), middle = (w0 + w1 + w2) * real(1.0 / 3.0);
    real x_low = min(dot(w0, low), min(dot(w1, low), dot(w2, low)));
    real x_high = max(dot(w0, high), max(dot(w1, high), dot(w2, high)));
    real spread = sqrt(max(dot(w0 - middle, w0 - middle), max(dot(w1 - middle, w1 - middle), dot(w2 - middle, w2 - middle))));
    real w_low = sqrt(dot(middle, middle)) - spread;
    real w_high = sqrt(max(dot(w0, w0), max(dot(w1, w1), dot(w2, w2))));
    // Texels around the part: what a texel's step changes of each weight, and beyond the triangle's own edges, where the
    // neighbour's third piece comes in as much as ours would go below 0.
    vec3 step = vec3(m.across_y + abs(m.up_x + m.up_y), m.up_x, m.across_y + abs(m.up_y)) * real(1.00001f) + vec3(real(1e-5f));
    real widest = max(step.x, max(step.y, step.z));
    vec3 least = min(w0, min(w1, w2)) - step;
    int edges = (least.x < real(0.0f) ? 1 : 0) + (least.y < real(0.0f) ? 1 : 0) + (least.z < real(0.0f) ? 1 : 0);
    real foreign = edges == 0 ? real(0.0f) : (edges == 1 ? real(2.0f) : real(10.0f)) * widest;
    real slack = real(0.5f) * (most_value - least_value) * (step.x + step.y + step.z) + foreign;
    x_low = max(x_low - slack, real(0.0f));
    x_high = min(x_high + slack, real(1.0f));
    w_low = max(w_low - sqrt(dot(step, step)) - foreign, real(0.57735f));
    w_high = min(w_high + sqrt(dot(step, step)) + foreign, real(1.0f));
    real g_low = soft_clip(x_low, x_low < real(0.5f) ? w_low : w_high);
    real g_high = soft_clip(x_high, x_high > real(0.5f) ? w_low : w_high);
    return vec2(restored(object, g_low - kBlendSlack), restored(object, g_high + kBlendSlack));
}

#endif
