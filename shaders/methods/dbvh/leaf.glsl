// The surface at a leaf: S with heights interpolated between every 2^level-th texel, linearly over two triangles a square,
// bilinearly, or as a biquadratic B-spline (thesis 000, section 4.2.5), met by Newton.
//
// Deviation: the thesis makes micro-triangles and patches between displaced corners, which lie beyond the triangle where
// the square reaches over its edge, and so differ between neighbours: its holes along base edges. Here a leaf only says
// what the height is; base point and normal stay those of S, so neighbours agree along their edge.
#ifndef RELIEVO_DBVH_LEAF_GLSL
#define RELIEVO_DBVH_LEAF_GLSL

const float kLeafBox = 0.0f, kLeafTriangles = 1.0f, kLeafBilinear = 2.0f, kLeafBspline = 3.0f;
const int kLeafSteps = 8;           // of Newton
const float kSameSheet = 0.6f;      // where the Jacobian's determinant changes by less, of itself, a root stands alone
const float kPieceBorder = 1e-3f;   // squares that a root may lie outside its piece at most,
const float kLeastBorder = 1e-5f;   // and at least

// A piece of the height: biquadratic in f, which goes from 0 to 1 over a square of `stride` texels at `origin`.
struct Piece {
    vec3 c0, c1, c2;   // polynomials in f.y of the powers of f.x, map values
    vec2 origin;       // texels relative to the primitive's base
    float stride;      // texels
    vec2 low, high;    // where it holds, in f
    float half_plane;  // triangles: f.x + f.y <= 1 (-1), >= 1 (1), or all (0)
};

FUNC int piece_count(float leaf) { return leaf == kLeafBspline ? 4 : (leaf == kLeafTriangles ? 2 : 1); }

// Map values at `count` by `count` texels, `stride` apart, a row each. One fetch in the code, for what it takes to compile:
// the loop's length is not known before it runs.
FUNC void control_values(uint object, vec2 texel, float stride, int count, OUT(vec3) r0, OUT(vec3) r1, OUT(vec3) r2) {
    bool by_one = count == 2 && stride == 1.0f;
    int fetches = by_one ? 1 : count * count;
    vec2 at = vec2(0.0f);
    r0 = vec3(0.0f);
    r1 = vec3(0.0f);
    r2 = vec3(0.0f);
    for (int i = 0; i < fetches; ++i) {
        vec4 q = height_quad(object, texel + at * stride);
        if (by_one) {
            r0 = vec3(q.x, q.y, 0.0f);
            r1 = vec3(q.z, q.w, 0.0f);
        } else {
            vec3 column = vec3(at.x == 0.0f ? q.x : 0.0f, at.x == 1.0f ? q.x : 0.0f, at.x == 2.0f ? q.x : 0.0f);
            r0 = r0 + column * (at.y == 0.0f ? 1.0f : 0.0f);
            r1 = r1 + column * (at.y == 1.0f ? 1.0f : 0.0f);
            r2 = r2 + column * (at.y == 2.0f ? 1.0f : 0.0f);
        }
        at.x = at.x + 1.0f;
        if (at.x == float(count)) at = vec2(0.0f, at.y + 1.0f);
    }
}

// Coefficients of a uniform quadratic B-spline's segment from three control points, each a polynomial of its own.
FUNC void bspline_segment(vec3 a, vec3 b, vec3 c, OUT(vec3) c0, OUT(vec3) c1, OUT(vec3) c2) {
    c0 = (a + b) * 0.5f;
    c1 = b - a;
    c2 = (a + c) * 0.5f - b;
}

FUNC Piece make_piece(Primitive p, float leaf, vec2 square, float stride, int index) {
    Piece e;
    vec2 base = primitive_base(p);
    e.stride = stride;
    e.origin = square;
    e.low = vec2(0.0f);
    e.high = vec2(1.0f);
    e.half_plane = 0.0f;
    // A B-spline's piece lies around one texel, from half a square before it to half a square after: the part within this
    // square.
    bool smooth_leaf = leaf == kLeafBspline;
    vec2 corner = vec2(float(index & 1), float(index >> 1)), texel = base + square;
    if (smooth_leaf) texel = texel + (corner - vec2(1.0f)) * stride;
    vec3 r0, r1, r2;
    control_values(p.object, texel, stride, smooth_leaf ? 3 : 2, r0, r1, r2);
    if (smooth_leaf) {
        vec3 a0, a1, a2;
        bspline_segment(r0, r1, r2, a0, a1, a2);
        // a_k: the power k of f.y, for the three columns. Across them likewise.
        bspline_segment(vec3(a0.x, a1.x, a2.x), vec3(a0.y, a1.y, a2.y), vec3(a0.z, a1.z, a2.z), e.c0, e.c1, e.c2);
        e.origin = square + (corner - vec2(0.5f)) * stride;
        e.low = vec2(0.5f) - 0.5f * corner;
        e.high = e.low + vec2(0.5f);
        return e;
    }
    vec4 q = vec4(r0.x, r0.y, r1.x, r1.y);
    e.c2 = vec3(0.0f);
    if (leaf == kLeafTriangles && index == 0) {
        e.c0 = vec3(q.x, q.z - q.x, 0.0f);
        e.c1 = vec3(q.y - q.x, 0.0f, 0.0f);
        e.half_plane = -1.0f;
    } else if (leaf == kLeafTriangles) {
        e.c0 = vec3(q.y + q.z - q.w, q.w - q.y, 0.0f);
        e.c1 = vec3(q.w - q.z, 0.0f, 0.0f);
        e.half_plane = 1.0f;
    } else {
        e.c0 = vec3(q.x, q.z - q.x, 0.0f);
        e.c1 = vec3(q.y - q.x, q.x - q.y - q.z + q.w, 0.0f);
    }
    return e;
}

FUNC float piece_value(Piece e, vec2 f) {
    return quadratic(e.c0, f.y) + f.x * (quadratic(e.c1, f.y) + f.x * quadratic(e.c2, f.y));
}

// Per texel.
FUNC vec2 piece_gradient(Piece e, vec2 f) {
    float by_x = quadratic(e.c1, f.y) + 2.0f * f.x * quadratic(e.c2, f.y);
    float y0 = e.c0.y + 2.0f * e.c0.z * f.y, y1 = e.c1.y + 2.0f * e.c1.z * f.y, y2 = e.c2.y + 2.0f * e.c2.z * f.y;
    return vec2(by_x, y0 + f.x * (y1 + f.x * y2)) / e.stride;
}

// Gradient, per texel, of the leaf of `stride` texels that lies over texel coordinates x.
FUNC vec2 leaf_gradient(Primitive p, float leaf, float stride, vec2 x) {
    vec2 base = primitive_base(p), square = floor((base + floor(x)) / stride) * stride - base;
    vec2 f = clamp((x - square) / stride, vec2(0.0f), vec2(1.0f));
    int index = 0;
    if (leaf == kLeafBspline) index = (f.x > 0.5f ? 1 : 0) + (f.y > 0.5f ? 2 : 0);
    else if (leaf == kLeafTriangles && f.x + f.y > 1.0f) index = 1;
    Piece e = make_piece(p, leaf, square, stride, index);
    return piece_gradient(e, (x - e.origin) / stride);
}

// `slack`: at its sides; `diagonal`: where it is half a square.
FUNC bool in_piece(Piece e, vec2 f, vec2 slack, float diagonal) {
    vec2 inside = min(f - e.low, e.high - f) + slack;
    return min(inside.x, inside.y) >= 0.0f && (f.x + f.y - 1.0f) * e.half_plane >= -diagonal;
}

// Least and greatest map value that a piece takes between two corners: those of its corners, or of the control points.
FUNC vec2 piece_bounds(Piece e, vec2 f0, vec2 f1) {
    if (e.c0.z != 0.0f || e.c1.z != 0.0f || e.c2 != vec3(0.0f)) {
        f0 = vec2(0.0f);
        f1 = vec2(1.0f);
    }
    float v0 = piece_value(e, f0), v1 = piece_value(e, vec2(f1.x, f0.y)), v2 = piece_value(e, vec2(f0.x, f1.y)),
          v3 = piece_value(e, f1);
    vec2 bounds = vec2(min(min(v0, v1), min(v2, v3)), max(max(v0, v1), max(v2, v3)));
    // What a biquadratic over [0, 1] may do between its corners: a quarter of its second differences.
    float bend = 0.25f * (abs(e.c0.z) + abs(e.c1.z) + abs(e.c2.z) + abs(e.c2.x) + abs(e.c2.y) + abs(e.c2.z));
    return bounds + vec2(-bend, bend);
}

// The leaf's cells that a rectangle of the domain lies over: one, where the domain is that of the texels, up to four where
// the triangle is thin. Walked piece by piece, a row of cells after the other.
struct LeafCells {
    vec2 low, high;    // the texels under the rectangle, relative to the primitive's base
    vec2 first, last;  // cells, likewise
    vec2 cell;         // where the walk is,
    int piece;         // and of the cell's pieces
};

// `square`: the cell, where it is one.
FUNC LeafCells leaf_cells(Primitive p, Domain g, vec2 square, float stride, vec2 middle, vec2 half_size) {
    LeafCells c;
    texels_under(g, middle, half_size, c.low, c.high);
    c.first = square;
    c.last = square;
    if (g.thin) {
        vec2 base = primitive_base(p);
        c.first = floor((base + floor(c.low)) / stride) * stride - base;
        c.last = floor((base + floor(c.high)) / stride) * stride - base;
    }
    c.cell = c.first;
    c.piece = 0;
    return c;
}

FUNC bool next_piece(float leaf, float stride, INOUT(LeafCells) c) {
    if (++c.piece < piece_count(leaf)) return true;
    c.piece = 0;
    c.cell.x = c.cell.x + stride;
    if (c.cell.x > c.last.x) c.cell = vec2(c.first.x, c.cell.y + stride);
    return c.cell.y <= c.last.y;
}

// Least and greatest map value of the leaf under the rectangle.
FUNC vec2 leaf_values(Primitive p, LeafCells c, float leaf, float stride) {
    vec2 bounds = vec2(1e30f, -1e30f);
    bool more = true;
    while (more) {
        vec2 f0 = clamp((c.low - c.cell) / stride, vec2(0.0f), vec2(1.0f)), f1 = clamp((c.high - c.cell) / stride, vec2(0.0f), vec2(1.0f));
        vec2 of = piece_bounds(make_piece(p, leaf, c.cell, stride, c.piece), f0, f1);
        bounds = vec2(min(bounds.x, of.x), max(bounds.y, of.y));
        more = next_piece(leaf, stride, c);
    }
    return bounds;
}

struct LeafRoot {
    vec2 b;
    float t;        // from the shifted origin
    bool inside;    // converged to a place in the piece
    bool decided;   // inside or not, there is no other
};

// What Newton's model leaves out within a step of `reach` units of the domain.
struct LeafDoubt {
    vec2 shift;    // units that a root may lie beside where the model has it
    float change;  // of the Jacobian's determinant, a part of it
};

FUNC float size_of(Domain g) { return max(g.q1x, max(abs(g.e2.x), abs(g.e2.y))); }

// What rounding may do to a place of S within the triangle, world units.
FUNC float place_rounding(Domain g, float rounding) { return 0.25f * rounding + 1.2e-7f * size_of(g); }

// And to the texel there: what a move of `blur` within the triangle's plane changes, and the sum of three edges rounds.
FUNC vec2 texel_rounding(Domain g, float blur) {
    vec2 along = g.s1 / g.q1x, across = (g.s2 - along * g.e2.x) / g.e2.y;
    return (abs(along) + abs(across)) * blur + (abs(g.s0) + abs(g.s1) + abs(g.s2)) * 3e-7f;
}

// Where the model is that of one place, with unit normal u there. `blur`: place_rounding. The height's second
// differences are exact for a bilinear square: with u held, the error is u times its cross term.
FUNC LeafDoubt leaf_doubt(Domain g, Piece e, float amplitude, vec3 u, vec3 across1, vec3 across2,
                          float det, float bend, float blur, vec2 reach) {
    float inverse = 1.0f / max(abs(det), 1e-30f);
    vec2 by = vec2(dot(u, across1), dot(u, across2)) * inverse, v = abs(g.t1 * by.x + g.t2 * by.y);
    vec2 step = abs(g.bx) * reach.x + abs(g.by) * reach.y;  // barycentric
    vec2 f = (g.thin ? abs(g.s1) * step.x + abs(g.s2) * step.y : reach) / e.stride;
    float xx = abs(e.c2.x) + abs(e.c2.y) + abs(e.c2.z), yy = abs(e.c0.z) + abs(e.c1.z) + abs(e.c2.z);
    float xy = abs(e.c1.y) + 2.0f * (abs(e.c1.z) + abs(e.c2.y)) + 4.0f * abs(e.c2.z), a = abs(amplitude);
    // The normal's turning moves S's second order by `bend` at most, its derivatives by twice that over the step.
    float l1 = length(across1) * inverse, l2 = length(across2) * inverse;
    LeafDoubt doubt;
    doubt.shift = v * (a * (xx * f.x * f.x + yy * f.y * f.y + xy * f.x * f.y)) + (abs(g.t1) * l1 + abs(g.t2) * l2) * (bend + blur);
    vec2 slope = vec2(2.0f * xx * f.x + xy * f.y, 2.0f * yy * f.y + xy * f.x) * (a / e.stride);
    doubt.change = dot(abs(g.s1 * by.x + g.s2 * by.y), slope) + 2.0f * bend * (l1 / max(step.x, 1e-20f) + l2 / max(step.y, 1e-20f));
    return doubt;
}

// Newton on S along the ray over one piece, from the middle of a rectangle of the domain.
// `o`: the ray's origin in the frame, near the triangle. `bend`: world units, what the normal's turning adds to S between
// the middle and the rectangle's border, to second order. `last`: a root will do, whether alone or not.
FUNC LeafRoot solve_piece(Domain g, ObjectData ob, Piece e, vec2 middle, vec2 half_size, vec3 o, vec3 d, float rounding,
                          float bend, bool last) {
    LeafRoot root;
    float blur = place_rounding(g, rounding);
    vec2 b = barycentrics_at(g, middle), x = g.t1 * b.x + g.t2 * b.y, reach = half_size * 1.001f + vec2(1e-6f) * abs(g.t0 + middle);
    vec2 furthest = reach * 1.25f;
    root.b = b;
    root.t = 0.0f;
    root.inside = false;
    root.decided = false;
    for (int i = 0; i < kLeafSteps; ++i) {
        vec2 f = (texels_of(g, b) - e.origin) / e.stride, slope = piece_gradient(e, f) * ob.amplitude;
        vec3 n = g.n0 + g.m1 * b.x + g.m2 * b.y;
        float inverse = 1.0f / max(length(n), 1e-20f), h = displacement(ob, piece_value(e, f));
        vec3 u = n * inverse, r = vec3(g.q1x * b.x, 0.0f, 0.0f) + g.e2 * b.y + u * h - o;
        vec3 s1 = vec3(g.q1x, 0.0f, 0.0f) + (g.m1 - u * dot(u, g.m1)) * (inverse * h) + u * dot(slope, g.s1);
        vec3 s2 = g.e2 + (g.m2 - u * dot(u, g.m2)) * (inverse * h) + u * dot(slope, g.s2);
        vec3 across1 = cross(s2, d), across2 = cross(d, s1);
        float det = dot(s1, across1), along = dot(r, d);
        // What lies along the ray would only round away what lies aside: over slivers, the whole of it.
        vec3 aside = r - d * along;
        vec2 change = vec2(dot(aside, across1), dot(aside, across2)) * (-1.0f / det);
        vec2 off = x + g.t1 * change.x + g.t2 * change.y - middle;
        if (!(max(abs(off.x), abs(off.y)) <= 1e9f)) return root;  // NaN too
        bool outside = abs(off.x) > reach.x || abs(off.y) > reach.y, beyond = abs(off.x) > furthest.x || abs(off.y) > furthest.y;
        if (i == 0 || outside) {
            float far = i == 0 ? 1.0f : 2.25f;
            LeafDoubt doubt = leaf_doubt(g, e, ob.amplitude, u, across1, across2, det, bend * far * far, blur, reach * far);
            if (abs(off.x) > reach.x + doubt.shift.x || abs(off.y) > reach.y + doubt.shift.y) {
                root.decided = true;
                return root;
            }
            if (i == 0) root.decided = doubt.change < kSameSheet;
            if (!(root.decided || last)) return root;
        }
        // Where the ray grazes, or the triangle is a sliver, rounding keeps the steps from shrinking further.
        float enough = i < 4 ? 1e-7f : 4e-6f, near = i < 4 ? 0.25f * rounding : blur;
        if (dot(aside, aside) <= near * near || max(abs(change.x), abs(change.y)) <= enough) {
            root.b = b + change;
            root.t = along + dot(s1, d) * change.x + dot(s2, d) * change.y;
            // As far outside the piece as rounding or the last step may have put it: further, the neighbour's height counts.
            vec2 texels = min(abs(g.s1 * change.x + g.s2 * change.y), vec2(1e-3f) * half_size) + texel_rounding(g, blur);
            vec2 border = min(vec2(kLeastBorder) + texels / abs(e.stride), vec2(kPieceBorder));
            root.inside = in_piece(e, (texels_of(g, root.b) - e.origin) / e.stride, border, kPieceBorder);
            return root;
        }
        // Texels always follow from the barycentrics: the other way rounding would part the height from its place.
        b = beyond ? barycentrics_at(g, middle + clamp(off, -furthest, furthest)) : b + change;
        x = g.t1 * b.x + g.t2 * b.y;
    }
    root.decided = false;
    return root;
}

#endif
