// Boxes of the displaced surface over squares of texture space, by affine arithmetic (thesis 000, section 4.2.4).
//
// Over a square the base point P and the normal N are affine in the texel coordinates, without error. Of |N| its square's
// bounds are taken (equation 2.6) and the root of those (2.7); the displacement comes from the min-max pyramid (4.16).
// Deviations from the thesis:
//  - D/|N| is bounded as one interval and multiplied into N, so that N's direction counts once, not as a product of two
//    ranges (4.17);
//  - squares are clipped to the triangle's texture footprint before they are bounded;
//  - boxes lie along the triangle's own axes: over a flat triangle they are as high as the map's range, not as the slope;
//  - a margin pays for rounding: without it neighbouring boxes touch at best, and rays pass between them;
//  - a triangle that is thin in texture space, or has no area there, is divided by its barycentrics in the place of texels,
//    where no place follows from the texture: its squares lie over up to four cells of the map (leaf.glsl).
#ifndef RELIEVO_DBVH_BOX_GLSL
#define RELIEVO_DBVH_BOX_GLSL

const float kLeastWidth = 0.015625f;  // texels: narrower triangles are thin,
const float kMostAspect = 64.0f;      // and those that are longer than this many times their width
const float kLeastLength = 2e-3f;     // of N: below, it is taken to point anywhere
const float kTurnOfRounding = 4e-7f;  // what rounding moves N by, at most

// The base triangle over a plane that is divided into squares: that of the texels, or of its barycentrics where it is thin,
// stretched so that a unit square is a texel at most. Coordinates x here are relative to vertex 0's, places to the
// triangle's frame (shared.h).
struct Domain {
    vec3 px, py;         // the base point per unit, 0 at x = 0
    vec3 n0, nx, ny;     // the interpolated normal, not normalised
    vec2 bx, by;         // barycentrics of vertices 1 and 2 per unit
    vec2 t0, t1, t2;     // vertex 0 relative to the primitive's base; edges to vertices 1 and 2
    bool thin;
    vec2 s0, s1, s2;     // texels, as t0 to t2 (which they are, unless the triangle is thin)
    vec2 low, high;      // footprint
    vec3 e2, m1, m2;     // P = (q1x, 0, 0) b.x + e2 b.y; N = n0 + m1 b.x + m2 b.y
    float q1x;
    float margin;        // world units: what rounding may do to a box,
    float b_rounding;    // and to barycentrics
};

struct DisplacedBox {
    vec3 low, high;  // the triangle's frame
    float turn;      // how far the normals over the square may turn, radians
};

FUNC vec3 in_frame(Primitive p, vec3 v) {
    return vec3(dot(v, p.tangent), dot(v, frame_bitangent(p)), dot(v, p.ng));
}

FUNC bool is_thin(Primitive p) {
    vec2 t1 = p.tx1 - p.tx0, t2 = p.tx2 - p.tx0;
    float longest = max(max(length(t1), length(t2)), length(t2 - t1)), area = abs(cross2(t1, t2));
    return !(area >= kLeastWidth * longest && area * kMostAspect >= longest * longest && longest > 0.0f);
}

FUNC Domain make_domain(Primitive p, PrimitiveNormals n, bool thin, float most_displacement, float rounding) {
    Domain g;
    g.s0 = p.tx0;
    g.s1 = p.tx1 - p.tx0;
    g.s2 = p.tx2 - p.tx0;
    g.t0 = g.s0;
    g.t1 = g.s1;
    g.t2 = g.s2;
    g.thin = thin;
    if (g.thin) {
        vec2 texels = abs(g.s1) + abs(g.s2);
        float side = max(1.02f * max(texels.x, texels.y), 1.0f);
        g.t0 = vec2(0.0f);
        g.t1 = vec2(side, 0.0f);
        g.t2 = vec2(0.0f, side);
    }
    float inverse = 1.0f / cross2(g.t1, g.t2);
    g.bx = vec2(g.t2.y, -g.t1.y) * inverse;
    g.by = vec2(-g.t2.x, g.t1.x) * inverse;
    g.q1x = p.q1x;
    g.e2 = vec3(p.q2, 0.0f);
    g.n0 = in_frame(p, n.n0);
    g.m1 = in_frame(p, n.n1) - g.n0;
    g.m2 = in_frame(p, n.n2) - g.n0;
    vec3 e1 = vec3(p.q1x, 0.0f, 0.0f);
    g.px = e1 * g.bx.x + g.e2 * g.bx.y;
    g.py = e1 * g.by.x + g.e2 * g.by.y;
    g.nx = g.m1 * g.bx.x + g.m2 * g.bx.y;
    g.ny = g.m1 * g.by.x + g.m2 * g.by.y;
    vec2 low = min(min(g.t1, g.t2), vec2(0.0f)), high = max(max(g.t1, g.t2), vec2(0.0f)), extent = high - low;
    // Neighbours overlap a little, and texel coordinates are rounded.
    vec2 slack = extent * 2e-5f + max(abs(g.t0), extent) * 4e-7f;
    g.low = low - slack;
    g.high = high + slack;
    float lever = (length(g.px) + most_displacement * length(g.nx)) * extent.x +
                  (length(g.py) + most_displacement * length(g.ny)) * extent.y;
    float placed = (length(g.px) + length(g.py)) * 4e-7f * max(abs(g.t0.x), abs(g.t0.y));
    vec2 span = abs(g.bx) * extent.x + abs(g.by) * extent.y;
    g.b_rounding = 2e-6f + 4e-7f * max(span.x, span.y);
    g.margin = rounding + 1e-6f * (lever + most_displacement) + placed;
    return g;
}

FUNC vec2 barycentrics_at(Domain g, vec2 x) { return g.bx * x.x + g.by * x.y; }

// Texels relative to the primitive's base.
FUNC vec2 texels_of(Domain g, vec2 b) { return g.s0 + g.s1 * b.x + g.s2 * b.y; }

// The texels that a rectangle lies over, likewise, from `low` to `high`.
FUNC void texels_under(Domain g, vec2 middle, vec2 half_size, OUT(vec2) low, OUT(vec2) high) {
    vec2 at = g.t0 + middle, reach = half_size;
    if (g.thin) {
        vec2 bx = abs(g.bx) * half_size.x, by = abs(g.by) * half_size.y;
        at = texels_of(g, barycentrics_at(g, middle));
        reach = abs(g.s1) * (bx.x + by.x) + abs(g.s2) * (bx.y + by.y);
        reach = reach + vec2(1e-4f) + (abs(g.s0) + abs(g.s1) + abs(g.s2)) * 4e-7f;
    }
    low = at - reach;
    high = at + reach;
}

// Whether the rectangle lies beyond one of the triangle's edges (section 4.2.7, in place of the GJK
// test): the greatest value of a barycentric, affine over it, is below -margin. What lies beyond the footprint has been
// clipped away.
FUNC bool outside_triangle(Domain g, vec2 middle, vec2 half_size, float margin) {
    float slack = margin + g.b_rounding;
    vec2 b = barycentrics_at(g, middle);
    vec2 reach = abs(g.bx) * half_size.x + abs(g.by) * half_size.y;
    float reach0 = abs(g.bx.x + g.bx.y) * half_size.x + abs(g.by.x + g.by.y) * half_size.y;
    return b.x + reach.x < -slack || b.y + reach.y < -slack || 1.0f - b.x - b.y + reach0 < -slack;
}

// What a displacement between d.x and d.y is of N over a rectangle: N's middle n, and what it changes by in both directions.
struct NormalScale {
    bool pointed;         // else N may point anywhere there
    float scale, radius;  // D/|N|: the middle of what it takes, and half the width
    float swing;          // world units: what rounding of N may move S by
    float turn;           // how far the normals may turn, radians
};

FUNC NormalScale normal_scale(vec3 n, vec3 nu, vec3 nv, vec2 d) {
    // |N|^2, equation 2.6; its square term is not negative, and within the triangle |N| <= 1.
    vec3 spread = abs(nu) + abs(nv);
    float centre = dot(n, n), linear = 2.0f * (abs(dot(n, nu)) + abs(dot(n, nv)));
    float shortest = (centre - linear) * 0.99999f - 2.0f * kTurnOfRounding * sqrt(centre);
    float longest = max(min(centre + linear + dot(spread, spread), 1.0f) * 1.00001f, shortest), most = max(abs(d.x), abs(d.y));
    NormalScale s;
    s.pointed = shortest > kLeastLength * kLeastLength;
    s.scale = 0.0f;
    s.radius = most;
    s.swing = 0.0f;
    s.turn = 10.0f;
    if (!s.pointed) return s;
    float i0 = inversesqrt(longest), i1 = inversesqrt(shortest);
    float g0 = d.x * (d.x > 0.0f ? i0 : i1), g1 = d.y * (d.y > 0.0f ? i1 : i0);
    s.scale = 0.5f * (g0 + g1);
    s.radius = 0.5f * (g1 - g0);
    s.swing = kTurnOfRounding * i1 * most;
    s.turn = 2.0f * length(spread) * i1;
    return s;
}

// Box of S over the rectangle where the displacement lies between d.x and d.y.
FUNC DisplacedBox displaced_box(Domain g, vec2 middle, vec2 half_size, vec2 d) {
    vec3 p = g.px * middle.x + g.py * middle.y, pu = g.px * half_size.x, pv = g.py * half_size.y;
    vec3 n = g.n0 + g.nx * middle.x + g.ny * middle.y, nu = g.nx * half_size.x, nv = g.ny * half_size.y;
    NormalScale of_n = normal_scale(n, nu, nv, d);
    // D/|N|, and its product with N.
    vec3 lean = of_n.pointed ? abs(n) + abs(nu) + abs(nv) : vec3(1.0f);
    vec3 s = p + n * of_n.scale;
    vec3 reach = abs(pu + nu * of_n.scale) + abs(pv + nv * of_n.scale) + lean * of_n.radius + vec3(g.margin + of_n.swing);
    DisplacedBox box;
    box.low = s - reach;
    box.high = s + reach;
    box.turn = of_n.turn;
    return box;
}

#endif
