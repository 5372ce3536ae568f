// First hit with S over one triangle whose shell folds over itself or stands far from the triangle's normal, where the
// path of a ray through the shell is torn: by subdivision of the base triangle with bounds, as renderer/reference does
// it in double, in single precision and with bounds that are cheap.
//
// A patch is a square of barycentrics. Over it S = P + e N, e = D/|N|: linear in e and, for each e, in the barycentrics, it
// lies in the hull of P_i + e_low N_i and P_i + e_high N_i at the patch's corners. Patches whose hull the ray passes, along
// the axes of its frame or across the columns that the patch's own normals make as the ray sees them, are dropped: where
// columns are high and lean away from the triangle's, only the last tells those apart. A patch of at most a texel is
// solved by Newton on S, cell by cell, so that what is solved is smooth, where bounds of the Jacobian say that it holds one
// root at most (Krawczyk 1969); else it is divided on. No stack: the patch's place among those of its depth is a Morton
// code, its bits turned so that the base triangle's near side comes first: what lies behind a hit is not divided.
#include "exact_sums.glsl"

const int kMaxPatches = 1048576;      // a triangle: beyond, the best of what was found counts
const int kPatchDepth = 15;
const float kPatchTexels = 1.0f;     // of a patch that is solved
const float kLeastLength = 1e-3f;    // of N: below, it is taken to point anywhere
const float kTurnOfRounding = 4e-7f; // what rounding moves N by, at most
const float kTexelRounding = 4e-7f;  // of a place in a patch, in texels
const float kSlabRounding = 1e-6f;   // of heights about a plane, of the map's range
const int kPatchSteps = 8;           // of Newton
const float kLeastStep = 1e-5f;      // barycentric: one that is true though what it leaves is rounding
const float kLeastPatch = 1e-4f;     // size of a patch that is not divided, of the greatest displacement
const float kAlone = 0.7f;           // below 1: how far the Jacobian may vary, over itself, where one root stands alone
const float kMostBorder = 1e-3f;     // texels that a root may lie outside its cell, and less where rounding allows it
const float kMostDoubt = 0.05f;      // barycentric: how far outside its patch, likewise

struct PatchFrame {      // the triangle as the ray sees it: x and y across, z along it from its origin
    vec3 p, p1, p2;      // base triangle: p + b1 p1 + b2 p2
    vec3 n, n1, n2;      // its normals, likewise
    vec2 tx, tx1, tx2;   // texels relative to the primitive's base
};

struct PatchBox {        // what the hull spans
    vec4 low, high;      // in the ray's frame; w: along `across`
    vec2 across;         // unit, across the ray and the columns over the patch's middle; 0 where the ray looks along them
};

struct PatchRoot {
    vec2 b;          // from the patch's corner
    float z;
    bool inside;     // converged to a place in the patch and the cell
    bool decided;    // inside or not, there is no other
};

FUNC PatchFrame make_patch_frame(Primitive p, PrimitiveNormals n, vec3 o, vec3 d) {
    // The first axis across the ray follows the normals: boxes of long thin columns stay narrow.
    vec3 along = n.n0 + n.n1 + n.n2;
    along = along - d * dot(along, d);
    vec3 other = abs(d.x) < 0.7f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
    other = other - d * dot(other, d);
    vec3 x = normalize(dot(along, along) > 1e-6f ? along : other), y = cross(d, x);
    float z = first_bits(dot(p.origin - o, d));
    vec3 from = from_ray(p.origin, o, d, z), e1 = base_edge1(p), e2 = base_edge2(p), m1 = n.n1 - n.n0, m2 = n.n2 - n.n0;
    PatchFrame f;
    f.p = vec3(dot(from, x), dot(from, y), z + dot(from, d));
    f.p1 = vec3(dot(e1, x), dot(e1, y), dot(e1, d));
    f.p2 = vec3(dot(e2, x), dot(e2, y), dot(e2, d));
    f.n = vec3(dot(n.n0, x), dot(n.n0, y), dot(n.n0, d));
    f.n1 = vec3(dot(m1, x), dot(m1, y), dot(m1, d));
    f.n2 = vec3(dot(m2, x), dot(m2, y), dot(m2, d));
    f.tx = p.tx0;
    f.tx1 = p.tx1 - p.tx0;
    f.tx2 = p.tx2 - p.tx0;
    return f;
}

FUNC vec2 patch_texel(PatchFrame f, vec2 b) { return f.tx + f.tx1 * b.x + f.tx2 * b.y; }

// patch_texel(f, corner) - from, rounded once: where a triangle has thousands of texels, rounding on the way would move a
// cliff's edge by more than the ray may pass it.
FUNC vec2 texel_from(PatchFrame f, vec2 corner, vec2 from) {
    vec2 lost = vec2(0.0f), sum = add_exactly(f.tx, vec2(0.0f) - from, lost);
    sum = add_product_exactly(sum, f.tx1, corner.x, lost);
    return add_product_exactly(sum, f.tx2, corner.y, lost) + lost;
}

// The same surface with barycentrics that count from the patch's corner, whose texel is given from wherever texels count.
FUNC PatchFrame frame_at(PatchFrame f, vec2 corner, vec2 texel) {
    f.p = f.p + f.p1 * corner.x + f.p2 * corner.y;
    f.n = f.n + f.n1 * corner.x + f.n2 * corner.y;
    f.tx = texel;
    return f;
}

// The texels that a patch covers whose corner lies at `a`.
FUNC void patch_texels(PatchFrame f, vec2 a, float side, OUT(vec2) low, OUT(vec2) high) {
    low = a + side * (min(f.tx1, vec2(0.0f)) + min(f.tx2, vec2(0.0f)));
    high = a + side * (max(f.tx1, vec2(0.0f)) + max(f.tx2, vec2(0.0f)));
}

// Least and greatest displacement over the patch, which covers the texels from `low` to `high`.
FUNC vec2 patch_displacement(Primitive p, ObjectData ob, vec2 low, vec2 high) {
    vec2 base = primitive_base(p);
    // Beyond a clamped map's borders heights stay what they are there, while the bounds kept there are of what lies inside.
    if (ob.clamp_wrap != 0u) {
        vec2 last = vec2(ob.map_size) - vec2(1.0f) - base;
        low = clamp(low, -base, last);
        high = clamp(high, -base, last);
    }
    vec2 extent = high - low + vec2(2e-3f), cell = floor(low);
    float most = max(extent.x, extent.y);
    if (most > power_of_two(kPyramidLevels)) return vec2(p.w_low, p.w_high);
    vec2 values;
    if (cell.x == floor(high.x) && cell.y == floor(high.y)) {
        // Within one cell the extremes of a bilinear height are at the corners.
        vec4 quad = height_quad(p.object, base + cell);
        vec2 f0 = low - cell, f1 = high - cell;
        float v0 = bilinear(quad, f0), v1 = bilinear(quad, vec2(f1.x, f0.y)), v2 = bilinear(quad, vec2(f0.x, f1.y)),
              v3 = bilinear(quad, f1);
        values = vec2(min(min(v0, v1), min(v2, v3)), max(max(v0, v1), max(v2, v3)));
    } else {
        vec2 from = floor(low - vec2(1e-3f));
        HeightSlab slab = height_slab(p.object, level_over(ob, most), base + from);
        vec2 middle = from + slab.middle;
        vec2 a = slab.slope * (low - middle - vec2(1e-3f)), b = slab.slope * (high - middle + vec2(1e-3f));
        vec2 least = min(a, b), greatest = max(a, b);
        values = slab.bounds + vec2(least.x + least.y - kSlabRounding, greatest.x + greatest.y + kSlabRounding);
    }
    float d0 = displacement(ob, values.x), d1 = displacement(ob, values.y);
    return vec2(max(min(d0, d1), p.w_low), min(max(d0, d1), p.w_high));
}

FUNC vec4 with_across(vec3 v, vec2 across) { return vec4(v.x, v.y, v.z, v.x * across.x + v.y * across.y); }

FUNC void hold(vec4 base, vec4 normal, vec2 e, INOUT(PatchBox) box) {
    vec4 a = base + normal * e.x, b = base + normal * e.y;
    box.low = min(box.low, min(a, b));
    box.high = max(box.high, max(a, b));
}

FUNC PatchBox patch_box(PatchFrame f, vec2 corner, float side, vec2 d) {
    vec3 n0 = f.n + f.n1 * corner.x + f.n2 * corner.y, n1 = f.n1 * side, n2 = f.n2 * side, middle = n0 + (n1 + n2) * 0.5f;
    float spread = 0.5f * max(length(n1 + n2), length(n1 - n2)), shortest = length(middle) - spread;
    float longest = max(max(length(n0), length(n0 + n1)), max(length(n0 + n2), length(n0 + n1 + n2)));
    bool pointed = shortest > kLeastLength;
    vec2 e = pointed ? vec2(d.x / (d.x < 0.0f ? shortest : longest), d.y / (d.y > 0.0f ? shortest : longest)) : vec2(0.0f);
    PatchBox box;
    float seen = length(vec2(middle.x, middle.y));
    box.across = vec2(-middle.y, middle.x) * (seen > 1e-6f ? 1.0f / seen : 0.0f);
    box.low = vec4(1e30f);
    box.high = vec4(-1e30f);
    vec4 p0 = with_across(f.p + f.p1 * corner.x + f.p2 * corner.y, box.across);
    vec4 p1 = with_across(f.p1 * side, box.across), p2 = with_across(f.p2 * side, box.across);
    vec4 m0 = with_across(n0, box.across), m1 = with_across(n1, box.across), m2 = with_across(n2, box.across);
    hold(p0, m0, e, box);
    hold(p0 + p1, m0 + m1, e, box);
    hold(p0 + p2, m0 + m2, e, box);
    hold(p0 + p1 + p2, m0 + m1 + m2, e, box);
    // Where N is short, rounding turns it.
    vec4 radius = vec4(max(abs(d.x), abs(d.y)) * (pointed ? kTurnOfRounding / shortest : 1.0f));
    box.low = box.low - radius;
    box.high = box.high + radius;
    return box;
}

FUNC bool box_met(PatchBox box, float rounding, float z_min, float z_max) {
    return max(max(box.low.x, box.low.y), box.low.w) <= rounding &&
           min(min(box.high.x, box.high.y), box.high.w) >= -rounding &&
           box.low.z - rounding <= z_max && box.high.z + rounding >= z_min;
}

// S(b) in the ray's frame and its derivatives, over the bilinear heights of the cell from which the frame counts texels.
struct PatchPoint {
    vec3 s, s1, s2;
    vec3 u;          // unit normal
    float length_n, d;
    vec2 g;          // of the map, per texel
};

FUNC PatchPoint patch_point(PatchFrame f, ObjectData ob, vec4 quad, vec2 b) {
    PatchPoint a;
    vec2 at = patch_texel(f, b);
    vec3 n = f.n + f.n1 * b.x + f.n2 * b.y;
    a.g = bilinear_gradient(quad, at);
    a.length_n = max(length(n), 1e-20f);
    float inverse = 1.0f / a.length_n;
    a.d = displacement(ob, bilinear(quad, at));
    a.u = n * inverse;
    a.s = f.p + f.p1 * b.x + f.p2 * b.y + a.u * a.d;
    a.s1 = f.p1 + (f.n1 - a.u * dot(a.u, f.n1)) * (inverse * a.d) + a.u * (ob.amplitude * dot(a.g, f.tx1));
    a.s2 = f.p2 + (f.n2 - a.u * dot(a.u, f.n2)) * (inverse * a.d) + a.u * (ob.amplitude * dot(a.g, f.tx2));
    return a;
}

// Newton's step towards where S meets the ray; and 1 over the determinant of its Jacobian across the ray.
FUNC float inverse_determinant(PatchPoint a) { return 1.0f / cross2(vec2(a.s1.x, a.s1.y), vec2(a.s2.x, a.s2.y)); }
FUNC vec2 newton_step(PatchPoint a, float inverse) {
    return vec2(a.s.x * a.s2.y - a.s.y * a.s2.x, a.s1.x * a.s.y - a.s1.y * a.s.x) * -inverse;
}

// How far the columns of S's Jacobian may be from those at the patch's middle, together: r is half the patch's side.
FUNC float jacobian_spread(PatchFrame f, ObjectData ob, vec4 quad, PatchPoint m, float r) {
    float turn = r * max(length(f.n1 + f.n2), length(f.n1 - f.n2)), least = m.length_n - turn;
    if (!(least > kLeastLength)) return 1e30f;
    float lean = turn / least;  // of the unit normal, and of 1/|N| as a part of itself
    float amplitude = abs(ob.amplitude), twist = abs(quad.x - quad.y - quad.z + quad.w);
    float dx = r * (abs(f.tx1.x) + abs(f.tx2.x)), dy = r * (abs(f.tx1.y) + abs(f.tx2.y));
    float rise = amplitude * (abs(m.g.x) * dx + abs(m.g.y) * dy + twist * dx * dy);
    float scaled = abs(m.d) / m.length_n, more = rise / least + scaled * lean;
    float slope1 = amplitude * twist * (dy * abs(f.tx1.x) + dx * abs(f.tx1.y));
    float slope2 = amplitude * twist * (dy * abs(f.tx2.x) + dx * abs(f.tx2.y));
    return (length(f.n1) + length(f.n2)) * (more + 2.0f * (scaled + more) * lean) + slope1 + slope2 +
           (amplitude * (abs(dot(m.g, f.tx1)) + abs(dot(m.g, f.tx2))) + slope1 + slope2) * lean;
}

// The roots of S across the ray over the patch and one cell. With J the Jacobian at the patch's middle m, every root b in
// the patch has |b - m + J^-1 s(m)| <= k |b - m|, k from the spread of J: that tells where none is, and where k < 1 that
// there is one at most (Krawczyk's operator, 1969). That one is found by Newton. `last`: look for one whatever k is.
// `f`: from the patch's corner, and the cell of `quad`.
FUNC PatchRoot solve_patch(ObjectData ob, PatchFrame f, vec2 corner, float side, vec4 quad, float rounding,
                           bool last) {
    PatchRoot root;
    float r = 0.5f * side, slack = 1e-3f * r + 1e-6f;
    vec2 middle = vec2(r), b = middle;
    root.b = b;
    root.z = 0.0f;
    root.inside = false;
    root.decided = false;
    PatchPoint a = patch_point(f, ob, quad, b);
    float inverse = inverse_determinant(a);
    vec2 change = newton_step(a, inverse);
    vec2 gain = vec2(abs(a.s2.x) + abs(a.s2.y), abs(a.s1.x) + abs(a.s1.y)) * abs(inverse);  // norms of J^-1's rows
    vec2 k = gain * jacobian_spread(f, ob, quad, a, r);
    vec2 out_of_reach = abs(change) - (vec2(r) + k * r + vec2(slack) + gain * rounding);
    root.decided = max(out_of_reach.x, out_of_reach.y) > 0.0f;
    if (root.decided) return root;
    root.decided = max(k.x, k.y) <= kAlone;
    // What evaluating S may round away.
    float size = max(abs(f.p.x), abs(f.p.y)) + max(abs(f.p1.x), abs(f.p1.y)) + max(abs(f.p2.x), abs(f.p2.y));
    float noise = max(0.25f * rounding, 2e-7f * size + (2e-7f + kTurnOfRounding / a.length_n) * abs(a.d) +
                                            0.5f * kTexelRounding * abs(ob.amplitude) * (abs(a.g.x) + abs(a.g.y)));
    if (!root.decided && !last) return root;
    // By so much rounding may move the root: across a sliver by more than its patches are wide, and then each would leave
    // it to the next. What is met beyond the patch is of S no less.
    vec2 doubt = min(gain * (rounding + noise), vec2(max(kMostDoubt, r)));
    for (int i = 0; i < kPatchSteps; ++i) {
        vec2 target = b + change, off = target - middle;
        if (!(max(abs(off.x), abs(off.y)) <= 1e6f)) return root;  // NaN too
        // Within rounding of the ray's place, or of the barycentrics'.
        if (max(abs(a.s.x), abs(a.s.y)) <= noise || max(abs(change.x), abs(change.y)) <= 1e-7f) {
            // A step further, where the Jacobian is sound enough.
            if (!(max(abs(change.x), abs(change.y)) <= slack)) {
                change = vec2(0.0f);
                off = b - middle;
            }
            root.b = b + change;
            root.z = a.s.z + a.s1.z * change.x + a.s2.z * change.y;
            gain = vec2(abs(a.s2.x) + abs(a.s2.y), abs(a.s1.x) + abs(a.s1.y)) * (abs(inverse) * (rounding + noise));
            vec2 beside = abs(off) - max(doubt, min(vec2(max(gain.x, gain.y)), vec2(r)));
            // How far its texel moves with the ray: up a cliff hardly at all, however far its barycentrics do.
            vec2 by_x = f.tx1 * a.s2.y - f.tx2 * a.s1.y, by_y = f.tx2 * a.s1.x - f.tx1 * a.s2.x;
            vec2 moves = (abs(by_x) + abs(by_y)) * (abs(inverse) * (rounding + noise));
            vec2 place = patch_texel(f, root.b), border = min(vec2(kTexelRounding) + moves, vec2(kMostBorder));
            vec2 beyond = place - clamp(place, vec2(0.0f), vec2(1.0f));
            root.inside = max(beside.x, beside.y) <= r + slack && abs(beyond.x) <= border.x && abs(beyond.y) <= border.y;
            // Beyond the cell other heights hold, beyond the triangle other surface: the ray must be within rounding of the
            // last place on this side.
            float turn = cross2(f.tx1, f.tx2);
            vec2 back = turn != 0.0f ? vec2(cross2(beyond, f.tx2), cross2(f.tx1, beyond)) * (1.0f / turn) : vec2(0.0f);
            vec2 kept = max(max(abs(beyond.x), abs(beyond.y)) > kTexelRounding ? root.b - back : root.b, vec2(0.0f) - corner);
            kept = kept - vec2(0.5f * max((corner.x + corner.y - 1.0f) + (kept.x + kept.y), 0.0f));
            if (root.inside && (kept.x != root.b.x || kept.y != root.b.y)) {
                vec3 s = patch_point(f, ob, quad, kept).s;
                root.inside = max(abs(s.x), abs(s.y)) <= rounding + noise;
            }
            return root;
        }
        vec2 reach = vec2(r + 2.0f * slack) + doubt;
        b = middle + clamp(off, -reach, reach);
        a = patch_point(f, ob, quad, b);
        inverse = inverse_determinant(a);
        change = newton_step(a, inverse);
    }
    // Steps that end without a root, but within reach of the patch, decide nothing.
    vec2 off = abs(b + change - middle) - doubt;
    root.decided = root.decided && max(off.x, off.y) > r + 2.0f * slack;
    return root;
}

// The even bits, moved together: a coordinate of a Morton code.
FUNC uint even_bits(uint v) {
    v = v & 0x55555555u;
    v = (v | (v >> 1u)) & 0x33333333u;
    v = (v | (v >> 2u)) & 0x0f0f0f0fu;
    v = (v | (v >> 4u)) & 0x00ff00ffu;
    return (v | (v >> 8u)) & 0x0000ffffu;
}

// A root counts as soon as rounding might be all that holds it off the ray, which over many high texels is a worst case.
// Newton's steps go on from there for as long as they bring S nearer.
FUNC void settle_root(ObjectData ob, PatchFrame f, vec4 quad, INOUT(PatchRoot) root) {
    PatchPoint a = patch_point(f, ob, quad, root.b);
    bool nearer = true;
    for (int i = 0; nearer && i < kPatchSteps; ++i) {
        vec2 change = newton_step(a, inverse_determinant(a)), b = root.b + change;
        vec2 place = patch_texel(f, b), beyond = abs(place - clamp(place, vec2(0.0f), vec2(1.0f)));
        PatchPoint next = patch_point(f, ob, quad, b);
        nearer = max(abs(next.s.x), abs(next.s.y)) < 0.5f * max(abs(a.s.x), abs(a.s.y)) &&
                 max(beyond.x, beyond.y) <= kMostBorder;
        if (nearer || max(abs(change.x), abs(change.y)) <= kLeastStep) {
            root.b = b;
            root.z = nearer ? next.s.z : a.s.z + a.s1.z * change.x + a.s2.z * change.y;
        }
        a = next;
    }
}

FUNC void take_root(Primitive p, ObjectData ob, PatchFrame f, vec2 corner, vec4 quad, vec2 cell, PatchRoot root, float t_min,
                    vec3 margin, INOUT(bool) found, INOUT(SurfaceHit) hit) {
    if (!root.inside || !in_triangle(corner + root.b, margin)) return;
    settle_root(ob, f, quad, root);
    vec2 b = corner + root.b;
    if (root.z < t_min || root.z > hit.t || !opaque_at(p, b)) return;
    note(kNoteRoot, root.z, cell + patch_texel(f, root.b), 0.0f, 0.0f);
    hit.t = root.z;
    hit.b = b;
    found = true;
}

FUNC bool search_patches(Primitive p, PrimitiveNormals n, ObjectData ob, vec3 o, vec3 d, float t_min, float t_max,
                         float rounding, vec3 margin, OUT(SurfaceHit) hit) {
    PatchFrame f = make_patch_frame(p, n, o, d);
    float texels = max(abs(f.tx1.x) + abs(f.tx2.x), abs(f.tx1.y) + abs(f.tx2.y));
    vec2 far = max(max(abs(f.tx), abs(f.tx + f.tx1)), abs(f.tx + f.tx2));
    float texel_rounding = 4e-7f * max(far.x, far.y);  // of places that count from the triangle
    float least = kLeastPatch * max(abs(p.w_low), abs(p.w_high)) + 2.0f * rounding;
    bool found = false;
    uint turned = (f.p1.z < 0.0f ? 0x55555555u : 0u) | (f.p2.z < 0.0f ? 0xaaaaaaaau : 0u), code = 0u;
    int depth = 0;
    hit.t = t_max;
    hit.b = vec2(0.0f, 0.0f);
    for (int i = 0; i < kMaxPatches; ++i) {
        float side = power_of_two(-depth);
        uint place = code ^ (turned & ((1u << uint(2 * depth)) - 1u));
        vec2 corner = vec2(float(even_bits(place)), float(even_bits(place >> 1u))) * side;
        bool down = false;
        if (corner.x + corner.y < 1.0f) {
            vec2 low, high;
            patch_texels(f, patch_texel(f, corner), side, low, high);
            vec2 range = patch_displacement(p, ob, low - vec2(texel_rounding), high + vec2(texel_rounding));
            PatchBox box = patch_box(f, corner, side, range);
            note(kNoteStep, 0.0f, patch_texel(f, corner), range.y, side * texels);
            if (box_met(box, rounding, t_min, hit.t)) {
                vec4 size = box.high - box.low;
                bool last = depth == kPatchDepth || max(max(size.x, size.y), size.z) <= least;
                down = !last;
                if (last || side * texels <= kPatchTexels) {
                    vec2 from = floor(low);
                    PatchFrame g = frame_at(f, corner, texel_from(f, corner, from));
                    patch_texels(g, g.tx, side, low, high);
                    vec2 first = floor(low), count = min(floor(high) - first, vec2(1.0f)), texel = g.tx;
                    bool decided = true;
                    for (int k = 0; k < 4; ++k) {
                        vec2 step = vec2(float(k & 1), float(k >> 1));
                        if (step.x > count.x || step.y > count.y) continue;
                        vec2 cell = from + (first + step);
                        g.tx = texel - (first + step);
                        vec4 quad = height_quad(p.object, primitive_base(p) + cell);
                        PatchRoot root = solve_patch(ob, g, corner, side, quad, rounding, last);
                        note(kNoteCell, root.z, cell + patch_texel(g, root.b), 0.0f, root.z);
                        decided = decided && root.decided;
                        take_root(p, ob, g, corner, quad, cell, root, t_min, margin, found, hit);
                    }
                    down = down && !decided;
                }
            }
        }
        if (down) {
            code <<= 2;
            ++depth;
            continue;
        }
        int done = findLSB(~code) >> 1;  // last children of their parents
        if (done >= depth) break;
        code = (code >> uint(2 * done)) + 1u;
        depth -= done;
    }
    return found;
}
