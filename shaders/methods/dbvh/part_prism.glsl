// Bounds of the displaced surface over a part of the lattice or a square of it, as displaced_box has them (box.glsl; thesis
// 000, equations 2.6, 2.7 and 4.16), along other axes.
//
// Deviation from the thesis, which makes boxes: three pairs of planes stand along the part's own edges, one pair lies along
// the triangle's plane. A lattice triangle's box, along whatever two axes, is at least twice as large as it is: with boxes
// rays met twice as many parts.
#ifndef RELIEVO_DBVH_PART_PRISM_GLSL
#define RELIEVO_DBVH_PART_PRISM_GLSL

// The domain and the ray measured along the planes' four normals.
struct PrismAxes {
    vec4 px, py, n0, nx, ny;  // of the domain
    vec4 o, inverse;          // of the ray
};

FUNC vec2 edge_normal(vec3 along) { return vec2(-along.y, along.x) * (1.0f / max(length(vec2(along.x, along.y)), 1e-20f)); }

FUNC vec4 along_axes(vec2 a, vec2 b, vec2 c, vec3 v) {
    vec2 flat_part = vec2(v.x, v.y);
    return vec4(dot(a, flat_part), dot(b, flat_part), dot(c, flat_part), v.z);
}

// Base points lie in the triangle's plane: px and py have no third part.
FUNC PrismAxes prism_axes(Domain g, DbvhRay r) {
    vec2 a = edge_normal(g.py), b = edge_normal(g.px), c = edge_normal(g.px - g.py);
    PrismAxes x;
    x.px = along_axes(a, b, c, g.px);
    x.py = along_axes(a, b, c, g.py);
    x.n0 = along_axes(a, b, c, g.n0);
    x.nx = along_axes(a, b, c, g.nx);
    x.ny = along_axes(a, b, c, g.ny);
    x.o = along_axes(a, b, c, r.o);
    vec4 d = along_axes(a, b, c, r.d);
    x.inverse = vec4(1.0f) / vec4(abs(d.x) < 1e-20f ? 1e-20f : d.x, abs(d.y) < 1e-20f ? 1e-20f : d.y,
                                  abs(d.z) < 1e-20f ? 1e-20f : d.z, abs(d.w) < 1e-20f ? 1e-20f : d.w);
    return x;
}

struct PartPrism {
    vec4 low, high;  // along the axes
    float turn;      // as in DisplacedBox
};

// `side`: 1 where only the rectangle's half at its lower corner counts, -1 at its upper one, 0 for all of it.
FUNC PartPrism part_prism(Domain g, PrismAxes x, vec2 middle, vec2 half_size, int side, vec2 d) {
    vec3 n = g.n0 + g.nx * middle.x + g.ny * middle.y, nu = g.nx * half_size.x, nv = g.ny * half_size.y;
    NormalScale of_n = normal_scale(n, nu, nv, d);
    PartPrism prism;
    prism.turn = of_n.turn;
    vec4 mid = x.n0 + x.nx * middle.x + x.ny * middle.y, mu = x.nx * half_size.x, mv = x.ny * half_size.y;
    // What a unit of the displacement is along the axes, at most.
    vec4 lean = of_n.pointed ? abs(mid) + abs(mu) + abs(mv) : vec4(1.0f);
    vec4 at = x.px * middle.x + x.py * middle.y + mid * of_n.scale;
    vec4 u = x.px * half_size.x + mu * of_n.scale, v = x.py * half_size.y + mv * of_n.scale;
    vec4 reach = lean * of_n.radius + vec4(g.margin + of_n.swing), both = abs(u) + abs(v);
    // Of the rectangle's corners a half has three: all but the one at u + v, or at -u - v.
    vec4 least = side == 0 ? -both : min(min(u - v, v - u), float(side) * (-u - v));
    vec4 most = side == 0 ? both : max(max(u - v, v - u), float(side) * (-u - v));
    prism.low = at + least - reach;
    prism.high = at + most + reach;
    return prism;
}

// Where the ray enters it, and leaves it.
FUNC vec2 prism_span(PartPrism prism, PrismAxes x) {
    vec4 a = (prism.low - x.o) * x.inverse, b = (prism.high - x.o) * x.inverse, near = min(a, b), far = max(a, b);
    return vec2(max(max(near.x, near.y), max(near.z, near.w)), min(min(far.x, far.y), min(far.z, far.w)));
}

#endif
