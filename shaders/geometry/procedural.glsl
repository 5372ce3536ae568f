// Procedural heights by tiling and blending: an endless map made of an exemplar. GLSL, C++ in float and in double.
//
// Thesis (paper 000) sections 4.1 and 5 after Heitz and Neyret 2018, "High-Performance By-Example Noise using a
// Histogram-Preserving Blending Operator": a lattice of triangles over texture space, a random piece of the exemplar at
// each vertex, the three pieces blended by the barycentrics with their variance kept, on values made Gaussian (mean 1/2,
// deviation 1/6) by the exemplar's histogram and led back by a table. Burley 2019, "On Histogram-Preserving Blending for
// Randomized Texture Tiling": the Gaussian is truncated at three deviations, so that it fills [0, 1] and nothing is clipped
// when values are stored; what the blend drives beyond the table's ends is bent back by his soft-clipping contrast (soft_clip)
// instead of being cut off, which would leave plateaus at the exemplar's least and greatest height.
//
// Ours, and different from the thesis:
//  - Offsets are whole texels of the exemplar, so that the three pieces' texels fall on one endless grid of "virtual texels".
//    The source gives the heights of those; between them the surface is bilinear, as that of any map (DESIGN.md section 1).
//    So all methods meet the very surface that a bake onto that grid would give, creases lie on texel lines only and never
//    on the lattice's edges, and what solves a cell of a map solves a cell of this.
//  - Lattice coordinates are 32.32 fixed point, linear in the virtual texel: lattice triangles and offsets are the same bits
//    on every device, however far from the origin.
//  - Bounds hold for squares of virtual texels, over all lattice triangles that they touch (the thesis bounds the parts of
//    one triangle): the pieces' extremes, numerator and denominator of the blend bounded apart (section 5.4.3), the
//    denominator as a norm (exact to first order) instead of by affine arithmetic.
//
// Given by the including side, `Source` being how it names an object (a number in shaders):
//   ProceduralData procedural_data(Source)
//   ivec2 exemplar_home(Source, ivec2 texel)      the virtual texel wrapped into the exemplar
//   ivec2 exemplar_shift(Source, uvec2 bits)      an offset of 0 to size - 1 from random bits
//   vec4 exemplar_quad(Source, ivec2 home, ivec2 shift)  Gaussianised texels (0,0) (1,0) (0,1) (1,1) from home + shift
//   real exemplar_value(Source, ivec2 home, ivec2 shift)
//   vec2 exemplar_bounds(Source, ivec2 home, ivec2 shift, ivec2 extent)  least and greatest over extent + 1 texels a side
//   vec2 inverse_pair(Source, int i)              entries i and i + 1 of the table that leads back
#ifndef RELIEVO_PROCEDURAL_GLSL
#define RELIEVO_PROCEDURAL_GLSL

const int kMostSquares = 4;           // lattice squares that bounds look into; beyond, those of the whole source
const real kBlendSlack = real(4e-6);  // what rounding may do to a blend, single precision

// Where a point lies in the lattice: in the square from `square` on, at `f` in it, in the half at its origin or beyond the
// diagonal from (1, 0) to (0, 1).
struct LatticePlace {
    ivec2 square;
    vec2 f;
    bool beyond;
};

FUNC real fixed_real(uvec2 v) { return real(int(v.y)) + real(v.x) * real(1.0 / 4294967296.0); }

// n * step, of fixed point numbers.
FUNC uvec2 fixed_times(int n, uvec2 step) {
    uint high, low;
    umulExtended(uint(n), step.x, high, low);
    high += uint(n) * step.y;
    if (n < 0) high -= step.x;
    return uvec2(low, high);
}

FUNC uvec2 fixed_sum(uvec2 a, uvec2 b) {
    uint carry;
    uint low = uaddCarry(a.x, b.x, carry);
    return uvec2(low, a.y + b.y + carry);
}

// The virtual texel's lattice coordinates.
FUNC void lattice_coordinates(ProceduralData data, ivec2 texel, OUT(uvec2) x, OUT(uvec2) y) {
    x = fixed_sum(data.start_x, fixed_times(texel.y, data.step_xy));
    y = fixed_sum(data.start_y, fixed_sum(fixed_times(texel.x, data.step_yx), fixed_times(texel.y, data.step_yy)));
}

FUNC LatticePlace lattice_place(uvec2 x, uvec2 y) {
    LatticePlace place;
    place.square = ivec2(int(x.y), int(y.y));
    place.f = vec2(real(x.x), real(y.x)) * real(1.0 / 4294967296.0);
    place.beyond = x.x + y.x < x.x;  // the sum of the fractions carries over
    return place;
}

// Vertices of the half of a square that holds the place: the right angle first, then along the first axis and the second.
FUNC ivec2 lattice_vertex(ivec2 square, bool beyond, int i) {
    ivec2 corner = i == 0 ? ivec2(0, 0) : (i == 1 ? ivec2(1, 0) : ivec2(0, 1));
    return square + (beyond ? ivec2(1, 1) - corner : corner);
}

// Barycentrics of a place of the square, or beyond its half's sides.
FUNC vec3 lattice_weights(vec2 f, bool beyond) {
    vec2 from = beyond ? vec2(1.0f, 1.0f) - f : f;
    return vec3(real(1.0f) - from.x - from.y, from.x, from.y);
}

// The exemplar's offset at a lattice vertex.
FUNC ivec2 vertex_shift(Source object, uint seed, ivec2 vertex) {
    uvec3 bits = pcg3d(uvec3(uint(vertex.x), uint(vertex.y), seed));
    return exemplar_shift(object, uvec2(bits.x, bits.y));
}

// Burley 2019: (x - 1/2) / w + 1/2 for x in [0, 1], bent so that it stays in [0, 1]; w, the blend's deviation, in
// [1/sqrt(3), 1]. It rises with x; with w it rises where x < 1/2 and falls beyond (bounds rely on both).
FUNC real soft_clip(real x, real w) {
    real u = x > real(0.5f) ? real(1.0f) - x : x;
    real result;
    if (u >= real(0.5f) - real(0.25f) * w) {
        result = (u - real(0.5f)) / w + real(0.5f);
    } else if (w >= real(2.0f) / real(3.0f)) {
        real s = u / (real(2.0f) - w);
        result = s * (real(8.0f) * (real(1.0f) / w - real(1.0f)) * s + real(3.0f) - real(2.0f) / w);
    } else {
        real s = max(u / w - real(0.5f) / w + real(0.75f), real(0.0f));
        result = s * s;
    }
    return x > real(0.5f) ? real(1.0f) - result : result;
}

// Back from a Gaussianised value to a height value.
FUNC real restored(Source object, real g) {
    real place = clamp(g, real(0.0f), real(1.0f)) * real(kInverseSize - 1);
    int i = min(int(place), kInverseSize - 2);
    vec2 pair = inverse_pair(object, i);
    return pair.x + (pair.y - pair.x) * (place - real(i));
}

// Variance-preserving blend (thesis equation 4.8) and the way back.
FUNC real blended(Source object, vec3 w, vec3 v) {
    return restored(object, soft_clip(dot(w, v), sqrt(dot(w, w))));
}

FUNC real texel_height(Source object, ProceduralData data, LatticePlace place, ivec2 home) {
    vec3 v;
    for (int i = 0; i < 3; ++i)
        v[i] = exemplar_value(object, home, vertex_shift(object, data.seed, lattice_vertex(place.square, place.beyond, i)));
    return blended(object, lattice_weights(place.f, place.beyond), v);
}

FUNC bool same_half(LatticePlace a, LatticePlace b) { return a.square == b.square && a.beyond == b.beyond; }

// Heights, in [0, 1], of the virtual texels (0,0) (1,0) (0,1) (1,1) of a cell.
FUNC vec4 procedural_quad(Source object, ivec2 cell) {
    ProceduralData data = procedural_data(object);
    uvec2 x, y;
    lattice_coordinates(data, cell, x, y);
    uvec2 up = fixed_sum(y, data.step_yy), x_up = fixed_sum(x, data.step_xy);
    LatticePlace a = lattice_place(x, y), b = lattice_place(x, fixed_sum(y, data.step_yx));
    LatticePlace c = lattice_place(x_up, up), d = lattice_place(x_up, fixed_sum(up, data.step_yx));
    ivec2 home = exemplar_home(object, cell);
    if (same_half(a, b) && same_half(a, c) && same_half(a, d)) {
        vec4 q0 = exemplar_quad(object, home, vertex_shift(object, data.seed, lattice_vertex(a.square, a.beyond, 0)));
        vec4 q1 = exemplar_quad(object, home, vertex_shift(object, data.seed, lattice_vertex(a.square, a.beyond, 1)));
        vec4 q2 = exemplar_quad(object, home, vertex_shift(object, data.seed, lattice_vertex(a.square, a.beyond, 2)));
        return vec4(blended(object, lattice_weights(a.f, a.beyond), vec3(q0.x, q1.x, q2.x)),
                    blended(object, lattice_weights(b.f, a.beyond), vec3(q0.y, q1.y, q2.y)),
                    blended(object, lattice_weights(c.f, a.beyond), vec3(q0.z, q1.z, q2.z)),
                    blended(object, lattice_weights(d.f, a.beyond), vec3(q0.w, q1.w, q2.w)));
    }
    return vec4(texel_height(object, data, a, home),
                texel_height(object, data, b, exemplar_home(object, cell + ivec2(1, 0))),
                texel_height(object, data, c, exemplar_home(object, cell + ivec2(0, 1))),
                texel_height(object, data, d, exemplar_home(object, cell + ivec2(1, 1))));
}

// Bounds of the blend, Gaussianised, over what a square of virtual texels has of one half of a lattice square. `middle`:
// the square's middle relative to the lattice square; `reach`: how far its corners lie from it, in both coordinates and
// in their sum.
FUNC vec2 half_bounds(Source object, ProceduralData data, ivec2 square, bool beyond, vec2 middle, vec3 reach, ivec2 home,
                      ivec2 extent) {
    vec3 low, high;
    for (int i = 0; i < 3; ++i) {
        vec2 range = exemplar_bounds(object, home, vertex_shift(object, data.seed, lattice_vertex(square, beyond, i)), extent);
        low[i] = range.x;
        high[i] = range.y;
    }
    // Each weight over the square, held to the triangle; the numerator is linear in them, and no mean leaves its values.
    vec3 w = lattice_weights(middle, beyond);
    vec3 spread = vec3(reach.z, reach.x, reach.y);
    vec3 least = clamp(w - spread, vec3(0.0f), vec3(1.0f)), most = clamp(w + spread, vec3(0.0f), vec3(1.0f));
    real mean_low = min(low.x, min(low.y, low.z)), mean_high = max(high.x, max(high.y, high.z));
    // At least least[i] of each piece, and the rest of the extreme one.
    real rest = max(real(1.0f) - least.x - least.y - least.z, real(0.0f));
    real x_low = dot(least, low) + rest * mean_low, x_high = dot(least, high) + rest * mean_high;
    // |w| is a norm: least where the weights are most alike.
    real size = sqrt(dot(w, w)), change = sqrt(dot(spread, spread));
    real w_low = max(max(size - change, sqrt(dot(least, least))), real(0.57735f));
    real w_high = min(min(size + change, sqrt(dot(most, most))), real(1.0f));
    return vec2(soft_clip(x_low, x_low < real(0.5f) ? w_low : w_high), soft_clip(x_high, x_high > real(0.5f) ? w_low : w_high));
}

// Least and greatest height, in [0, 1], of the virtual texels from `first` to first + extent, both included.
FUNC vec2 procedural_bounds(Source object, ivec2 first, ivec2 extent) {
    ProceduralData data = procedural_data(object);
    uvec2 x, y;
    lattice_coordinates(data, first, x, y);
    LatticePlace place = lattice_place(x, y);
    vec2 size = vec2(real(extent.x), real(extent.y));
    real up_x = fixed_real(data.step_xy);
    real across_y = fixed_real(data.step_yx);
    // The lattice's shape: up, the second coordinate falls by half of what the first gains.
    vec3 half_size = real(0.5f) * vec3(size.y * up_x, size.x * across_y + size.y * up_x * real(0.5f),
                                       size.x * across_y + size.y * up_x * real(0.5f));
    vec2 middle = place.f + real(0.5f) * vec2(size.y * up_x, size.x * across_y - size.y * up_x * real(0.5f));
    vec3 reach = half_size + vec3(real(1e-5f)) + half_size * real(1e-5f);
    vec2 low = floor(middle - vec2(reach.x, reach.y)), high = floor(middle + vec2(reach.x, reach.y));
    vec2 count = high - low + vec2(1.0f);
    if (!(count.x * count.y <= real(kMostSquares))) return vec2(real(data.range.x), real(data.range.y));
    ivec2 home = exemplar_home(object, first);
    vec2 g = vec2(1.0f, 0.0f);
    for (real v = low.y; v <= high.y; v += real(1.0f)) {
        for (real u = low.x; u <= high.x; u += real(1.0f)) {
            vec2 within = middle - vec2(u, v);
            ivec2 square = place.square + ivec2(int(u), int(v));
            for (int k = 0; k < 2; ++k) {
                bool beyond = k == 1;
                real sum = within.x + within.y;
                if (beyond ? sum + reach.z < real(1.0f) : sum - reach.z > real(1.0f)) continue;
                vec2 range = half_bounds(object, data, square, beyond, within, reach, home, extent);
                g = vec2(min(g.x, range.x), max(g.y, range.y));
            }
        }
    }
    return vec2(restored(object, g.x - kBlendSlack), restored(object, g.y + kBlendSlack));
}

#endif
