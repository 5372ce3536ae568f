// The parallel offset prism of paper 002 (section 4), in the triangle's own frame.
//
// The offset triangle at height w has the vertices q_i + w shift_i, linear in w and so linear along a ray. The
// barycentrics of the ray's point are then ratios of areas, each a quadratic in t over their sum (also a quadratic):
//   b_i(t) = N_i(t) / (N_0 + N_1 + N_2),   N_i = (q_j + w shift_j - s) x (q_k + w shift_k - s).
// The prism's bilinear sides are the roots of the numerators, so clipping is three quadratics; no patch test is
// needed (deviation from the paper, which intersects the sides with "cool patches": same sides, cheaper).
#ifndef RELIEVO_PRISM_GLSL
#define RELIEVO_PRISM_GLSL

RELIEVO_CONST float kRayEnd = 1e30f;  // what t_max may be at most

struct PrismRay {
    float t0;          // the ray parameter at tau = 0
    float low, high;   // tau where the ray is inside (one stretch; a hole inside it is possible, samples must test)
    float w0, wd;      // height over the base plane: w0 + wd tau
    float rise;        // of the ray over the planes at the prism's ends, per unit of tau; wd, where they are not slanted
    vec2 x0, xd;       // the ray in the frame's plane: x0 + xd tau
    vec3 n0, n1, n2;   // constant, linear, square coefficient of each numerator in tau
    bool from_side;    // entered through a bilinear side (not an end, not started inside)
    uint entry_edge;   // then: the side's edge, opposite vertex 0, 1 or 2
    bool from_inside;  // the ray starts inside the prism
};

FUNC vec3 area_coefficients(vec2 a, vec2 da, vec2 b, vec2 db) {
    return vec3(cross2(a, b), cross2(a, db) + cross2(da, b), cross2(da, db));
}

FUNC float quadratic(vec3 c, float x) { return c.x + x * (c.y + x * c.z); }

// Narrows [low, high] to where c.x + c.y x + c.z x^2 >= 0; keeps both parts when the gap lies strictly inside.
// `entered` tells that `low` moved. Returns false when nothing is left.
FUNC bool clip_quadratic(vec3 c, INOUT(float) low, INOUT(float) high, OUT(bool) entered) {
    entered = false;
    float disc = c.y * c.y - 4.0f * c.z * c.x;
    if (!(disc > 0.0f)) return c.x >= 0.0f;
    float q = -0.5f * (c.y + (c.y < 0.0f ? -sqrt(disc) : sqrt(disc)));
    // A root at infinity (c.z = 0) stays finite and far away.
    float r0 = abs(c.z) * 1e30f > abs(q) ? q / c.z : (q * c.z < 0.0f ? -1e30f : 1e30f);
    float r1 = q != 0.0f ? c.x / q : 0.0f;
    float a = min(r0, r1), b = max(r0, r1);
    if (c.z < 0.0f || (c.z == 0.0f && c.y == 0.0f)) {
        if (a > low) { low = a; entered = true; }
        high = min(high, b);
    } else if (c.z == 0.0f) {
        if (c.y > 0.0f) { if (r1 > low) { low = r1; entered = true; } }
        else high = min(high, r1);
    } else {
        if (low > a && low < b) { low = b; entered = true; }
        if (high > a && high < b) high = a;
    }
    return low <= high;
}

// A folded prism's sides cross: clip to the box of its six corners instead, samples do the rest.
FUNC bool clip_folded(Primitive p, vec2 x0, vec2 xd, INOUT(float) low, INOUT(float) high) {
    vec2 q1 = vec2(p.q1x, 0.0f);
    vec2 a0 = p.shift0 * p.w_low, a1 = q1 + p.shift1 * p.w_low, a2 = p.q2 + p.shift2 * p.w_low;
    vec2 c0 = p.shift0 * p.w_high, c1 = q1 + p.shift1 * p.w_high, c2 = p.q2 + p.shift2 * p.w_high;
    vec2 box_low = min(min(min(a0, a1), min(a2, c0)), min(c1, c2));
    vec2 box_high = max(max(max(a0, a1), max(a2, c0)), max(c1, c2));
    if (xd.x != 0.0f) {
        float a = (box_low.x - x0.x) / xd.x, b = (box_high.x - x0.x) / xd.x;
        low = max(low, min(a, b));
        high = min(high, max(a, b));
    } else if (x0.x < box_low.x || x0.x > box_high.x) return false;
    if (xd.y != 0.0f) {
        float a = (box_low.y - x0.y) / xd.y, b = (box_high.y - x0.y) / xd.y;
        low = max(low, min(a, b));
        high = min(high, max(a, b));
    } else if (x0.y < box_low.y || x0.y > box_high.y) return false;
    return low <= high;
}

// What rounding may move a point of a ray by, beside the triangle: the further its origin, the more.
FUNC float rounding_of_ray(Primitive p, vec3 o) {
    vec3 away = abs(o - p.origin);
    return 3e-7f * max(max(away.x, away.y), away.z);
}

// How far the planes at the prism's ends rise along the frame's x and y.
FUNC vec2 slant_of(Primitive p) {
    if (!kSlants) return vec2(0.0f, 0.0f);
    return vec2(float(int(p.flags << (32 - kSlantShiftY)) >> kSlantShiftY), float(int(p.flags) >> kSlantShiftY)) * kSlantStep;
}

// The primitive with its prism higher by that much. A flat triangle's is so thin that a sample before the surface and one
// behind it could round to one side.
FUNC Primitive higher(Primitive p, float rounding) {
    vec2 slant = abs(slant_of(p));
    rounding *= 1.0f + slant.x + slant.y;
    p.w_low -= rounding;
    p.w_high += rounding;
    return p;
}

// Clips the ray to the prism. `margin` widens the sides by that fraction of the base triangle's area, so that rays
// along a shared side belong to both neighbours and none is lost to rounding.
FUNC bool enter_prism(Primitive p, vec3 o, vec3 d, float t_min, float t_max, float margin, OUT(PrismRay) r) {
    vec3 bitangent = cross(p.ng, p.tangent);
    vec3 from = o - p.origin;
    float w = dot(from, p.ng);
    r.wd = dot(d, p.ng);
    vec2 xd = vec2(dot(d, p.tangent), dot(d, bitangent));
    float over = w;  // height over the slanted planes, likewise
    r.rise = r.wd;
    if (kSlants) {
        vec2 slant = slant_of(p);
        over -= dot(slant, vec2(dot(from, p.tangent), dot(from, bitangent)));
        r.rise -= dot(slant, xd);
    }
    float t0 = t_min, t1 = t_max;
    if (r.rise != 0.0f) {
        float a = (p.w_low - over) / r.rise, b = (p.w_high - over) / r.rise;
        t0 = max(t0, min(a, b));
        t1 = min(t1, max(a, b));
    } else if (over < p.w_low || over > p.w_high) {
        return false;
    }
    if (!(t0 <= t1)) return false;
    // Re-origin at the slab's entry: the quadratics then live at the prism's own scale.
    vec3 s = from + d * t0;
    vec2 x0 = vec2(dot(s, p.tangent), dot(s, bitangent));
    r.t0 = t0;
    r.x0 = x0;
    r.xd = xd;
    r.w0 = w + r.wd * t0;
    vec2 a0 = p.shift0 * r.w0 - x0, d0 = p.shift0 * r.wd - xd;
    vec2 a1 = vec2(p.q1x, 0.0f) + p.shift1 * r.w0 - x0, d1 = p.shift1 * r.wd - xd;
    vec2 a2 = p.q2 + p.shift2 * r.w0 - x0, d2 = p.shift2 * r.wd - xd;
    r.n0 = area_coefficients(a1, d1, a2, d2);
    r.n1 = area_coefficients(a2, d2, a0, d0);
    r.n2 = area_coefficients(a0, d0, a1, d1);
    r.low = 0.0f;
    r.high = t1 - t0;
    r.from_side = false;
    r.entry_edge = 0u;
    r.from_inside = false;
    if ((p.flags & kPrimitiveFolded) != 0u) return clip_folded(p, x0, xd, r.low, r.high);
    float widen = margin * p.q1x * p.q2.y;
    bool entered = false;
    vec3 widened = vec3(widen, 0.0f, 0.0f);
    // Most boxes that a ray meets hold a prism that it misses: one with a numerator that is negative at both ends of the
    // slab, beyond rounding, and cannot bow up to zero between them. That takes no roots.
    float bow = 0.2501f * r.high * r.high, slack = 1e-6f * r.high;
    float most0 = max(r.n0.x, quadratic(r.n0, r.high)) + abs(r.n0.z) * bow + abs(r.n0.y) * slack;
    float most1 = max(r.n1.x, quadratic(r.n1, r.high)) + abs(r.n1.z) * bow + abs(r.n1.y) * slack;
    float most2 = max(r.n2.x, quadratic(r.n2, r.high)) + abs(r.n2.z) * bow + abs(r.n2.y) * slack;
    if (min(min(most0, most1), most2) + widen < 0.0f) return false;
    if (!clip_quadratic(r.n0 + widened, r.low, r.high, entered)) return false;
    if (entered) { r.from_side = true; r.entry_edge = 0u; }
    if (!clip_quadratic(r.n1 + widened, r.low, r.high, entered)) return false;
    if (entered) { r.from_side = true; r.entry_edge = 1u; }
    if (!clip_quadratic(r.n2 + widened, r.low, r.high, entered)) return false;
    if (entered) { r.from_side = true; r.entry_edge = 2u; }
    r.from_inside = t0 == t_min && r.low == 0.0f;
    return true;
}

// Barycentrics (b0, b1, b2) of the ray's point on the offset triangle through it.
FUNC vec3 prism_barycentrics(PrismRay r, float tau) {
    vec3 n = vec3(quadratic(r.n0, tau), quadratic(r.n1, tau), quadratic(r.n2, tau));
    return n * (1.0f / (n.x + n.y + n.z));
}

#endif
