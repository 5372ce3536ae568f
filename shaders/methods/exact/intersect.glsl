// Exact intersection with the canonical surface (ours; DESIGN.md section 4).
//
// The ray's path through the triangle's shell (geometry/shell.glsl) is cut into chords, each as long as its bend
// allows: beside the chord the path stays within a part of a texel, its height is a quadratic of its own. A chord is
// walked by stretches of at most 2^level texels; one that stays above (or below) the bounds of the cells under it is
// skipped, and of another what comes before it enters them. The bounds lie about planes, in a pyramid whose nodes
// overlap (renderer/height_slabs.h): one fetch bounds the two by two nodes that such a stretch can touch. Where nothing
// can be skipped the cells are walked one by one; over a cell the height along the chord is a quadratic, solved, then
// polished by Newton on S itself. Based on quadtree displacement mapping (Drobot 2009) and tessellation-free
// displacement (Thonat and others 2021); the path, the overlap, the planes and the polish are ours. Triangles whose
// shell folds are searched by patches instead (patch_search.glsl).
//
// What side of the surface the ray is on is carried along: a cell that starts on the other side has been crossed. A ray
// that passes the surface more closely than the chord is true, or whose root leaves its cell when polished, is walked again
// over a shorter chord, so that coarse chords cost no grazing hit. Limits: what touches within rounding; see also
// renderer/stability/promises.cpp.
//
// Parameters: x: correct_normals (0 or 1).
const int kMaxStretches = 131072;    // a triangle: beyond, the ray counts as a miss
const int kMaxCells = 10;            // a leaf is at most 4 texels long
const int kMaxTries = 8;             // for a chord's length
const float kLongestChord = 256.0f;  // texels
const float kEdgeMargin = 1e-5f;     // barycentric: neighbours overlap by this, so that no ray slips between,
const float kOpenMargin = 0.0f;     // at an edge without neighbour: beyond it stands nothing
const float kMostEdgeMargin = 1e-3f; // or by more where a far ray's rounding asks for it
const float kBend = 0.05f;           // texels that the path may leave its chord,
const float kMostTurn = 0.1f;        // part of its length, or of a texel, that it may bend,
const float kHeightError = 1e-4f;    // how far its height may leave the quadratic, of the amplitude
const float kFirstStep = 3e-4f;      // barycentric: one of Newton's steps this short leaves less than its square;
const float kFirmBend = 0.25f;       // barycentric: beyond, Newton's steps at a chord's end are not trusted
const float kSureError = 2e-6f;      // of the amplitude: a chord this true decides every passage;
const float kRefinement = 0.2f;      // one that cannot is cut to this part of itself,
const float kLeastSpan = 1e-4f;      // down to this part of the path
const float kTornSpan = 1e-3f;       // part of the path that is passed over where no chord holds;
const float kSpanRounding = 2e-6f;   // neither less than this part of the way from the prism's end, which would round away
const float kEntryRounding = 1e-6f;  // of the distance: hits of neighbours may be equally far, and either's prism begin there
const float kShortChord = 4.0f;      // texels: between slanted ends it hardly passes the surface, and is a leaf
const float kBorder = 1e-5f;         // texels that a polished root may lie outside its cell, beside its rounding
const float kThere = 1e-4f;          // of the triangle's size: how far a root's shell coordinates may lead beside the ray
const int kPolishSteps = 8;          // of Newton: near a double root each only halves the way
const float kRest = 3e-6f;           // of the amplitude: a gap that Newton's steps have closed;
const float kLastStep = 1e-3f;       // or the last step was shorter than this, in texels and barycentrics
const float kAtOnce = 0.3f;          // of a closed gap: what a first and only step may leave

struct Chord {        // the path as s goes from 0 to 1: quadratics in s
    float tau, span;  // along the ray
    vec2 b, b1, b2;   // barycentrics: constant, linear and square coefficient
    vec2 tx, d1, d2;  // texels, likewise
    vec3 h;           // height, likewise
    float bend;       // texels that the path may lie beside it
    float error;      // of the height
};

struct Walk {
    Chord c;
    ShellPoint end;  // of the chord
    float s;         // reached
    float longest;   // along the ray: of the next chord
    float side;      // 1: above the surface, -1: below, 0: not known
    int level;
    int stretches;   // walked
};

FUNC bool in_triangle(vec2 b, vec3 margin) {
    return b.x >= -margin.y && b.y >= -margin.z && 1.0f - b.x - b.y >= -margin.x;
}

// Of the bounds that are kept: the finest level's, and the least one's whose squares are as wide as so many texels.
FUNC int least_level(ObjectData ob) { return 1 + ob.slabs_left_out; }
FUNC int level_over(ObjectData ob, float texels) {
    return max(((floatBitsToInt(max(texels, 1.0f)) + 0x7fffff) >> 23) - 127, least_level(ob));
}

// Texels that the chord covers along an axis as s goes from 0 to 1, were it everywhere as fast as where it is fastest.
FUNC float texel_rate(Chord c) {
    vec2 rate = max(abs(c.d1), abs(c.d1 + c.d2 * 2.0f));
    return max(max(rate.x, rate.y), 1e-20f);
}

#include "patch_search.glsl"

// Smallest root of c.x + c.y s + c.z s^2 in [from, to]; false when there is none.
FUNC bool first_root(vec3 c, float from, float to, OUT(float) root) {
    root = to;
    float disc = c.y * c.y - 4.0f * c.z * c.x;
    if (disc < 0.0f) return false;
    float q = -0.5f * (c.y + (c.y < 0.0f ? -sqrt(disc) : sqrt(disc)));
    float r0 = abs(c.z) * 1e15f > abs(q) ? q / c.z : 1e15f;
    float r1 = q != 0.0f ? c.x / q : (c.x == 0.0f ? 0.0f : 1e15f);
    float low = min(r0, r1), high = max(r0, r1);
    root = low >= from ? low : high;
    return root >= from && root <= to;
}

// Newton on S along the ray, in the bilinear patch of one cell, from a root on the chord. False where no root is near.
// `enough`: a gap to the surface that is closed. `bend`: what the path's square coefficients, over one unit of tau, do to
// that gap. `slope`: of the gap there, over tau.
FUNC bool polish(Primitive p, ObjectData ob, Shell s, PrismRay r, vec2 cell, vec4 quad, float reach, float enough,
                 float bend, INOUT(vec2) b, INOUT(float) tau, OUT(float) slope) {
    float twist = abs(ob.amplitude * (quad.x - quad.y - quad.z + quad.w));
    slope = 0.0f;
    for (int i = 0; i < kPolishSteps; ++i) {
        ShellPoint a = shell_point(p, s, r, tau, b, 1);
        vec2 f = a.tx - cell;
        vec2 g = bilinear_gradient(quad, f);
        slope = a.dh - ob.amplitude * (g.x * a.dtx.x + g.y * a.dtx.y);
        float gap = a.h - displacement(ob, bilinear(quad, f));
        float step_back = slope != 0.0f ? clamp(gap / slope, -reach, reach) : 0.0f;
        float rounding = 2e-6f * max(abs(a.tx.x), abs(a.tx.y));
        vec2 moved = abs(a.dtx * step_back), guessed = abs(a.b - b);
        bool last = max(moved.x, moved.y) <= kLastStep + rounding &&
                    abs(step_back) * max(abs(a.db.x), abs(a.db.y)) <= kLastStep;
        bool closed = abs(gap) <= enough;
        // A first step so short that the gap it leaves needs no second look.
        bool at_once = max(guessed.x, guessed.y) <= kLastStep &&
                       twist * moved.x * moved.y + bend * step_back * step_back <= kAtOnce * enough;
        if (closed && !last && !at_once) step_back = 0.0f;  // the ray touches: the slope says nothing
        tau -= step_back;
        b = a.b - a.db * step_back;
        if (at_once || (i > 0 && (closed || last))) return true;
    }
    return false;
}

FUNC bool is_slanted(Primitive p) { return kSlants && (p.flags & kPrimitiveSlanted) != 0u; }

// Two of Newton's steps; between slanted ends, where the guess is mostly that good, one may do.
FUNC ShellPoint chord_end(Primitive p, Shell shell, PrismRay r, float tau, vec2 guess) {
    if (!kSlants) return shell_point(p, shell, r, tau, guess, 2);
    ShellPoint a = shell_point(p, shell, r, tau, guess, 1);
    vec2 moved = abs(a.b - guess);
    if (!is_slanted(p) || !(max(moved.x, moved.y) < kFirstStep)) a = shell_point(p, shell, r, tau, a.b, 1);
    return a;
}

// The next chord, where the last one ended (which is before the ray leaves the shell).
FUNC void start_chord(Primitive p, ObjectData ob, Shell shell, PrismRay r, float most_error, float least_span,
                      INOUT(Walk) w) {
    ShellPoint a = w.end;
    float tau = w.c.tau + w.c.span;
    float reach = kLongestChord / max(max(abs(a.dtx.x), abs(a.dtx.y)), 1e-20f);
    float span = min(min(r.high - tau, reach), w.longest), over = 0.0f;
    Chord c;
    for (int k = 0; k < kMaxTries; ++k) {
        w.end = chord_end(p, shell, r, tau + span, a.b + a.db * span);
        c.b1 = a.db * span;
        c.d1 = a.dtx * span;
        c.h = vec3(a.h, a.dh * span, w.end.h - a.h - a.dh * span);
        c.b2 = w.end.b - a.b - c.b1;
        c.d2 = w.end.tx - a.tx - c.d1;
        // Quadratics through both ends and the first slope are off by cubics that the last slope tells.
        vec2 off = abs(w.end.dtx * span - c.d1 - c.d2 * 2.0f);
        c.bend = 0.15f * max(off.x, off.y);
        c.error = 0.15f * abs(w.end.dh * span - c.h.y - 2.0f * c.h.z);
        float turn = max(abs(c.d2.x), abs(c.d2.y)) / (kMostTurn * max(max(abs(c.d1.x), abs(c.d1.y)), 1.0f));
        vec2 off_b = abs(c.b2);
        over = max(max(max(c.bend * (1.0f / kBend), turn * turn), max(off_b.x, off_b.y) * (1.0f / kFirmBend)),
                   c.error / most_error);
        if (over <= 1.0f || k == kMaxTries - 1) break;
        span = max(span * (over < 64.0f ? 0.9f * inversesqrt(over) : 0.1f), least_span);  // NaN: the latter
    }
    w.s = 0.0f;
    if (!(over <= 1.0f) && span <= least_span) {
        // Beyond the triangle the shell may fold, and the path through it is torn: on from the prism's place.
        span = min(max(kTornSpan * (r.high - r.low), 4.0f * least_span), r.high - tau);
        vec3 place = prism_barycentrics(r, tau + span);
        w.end = shell_point(p, shell, r, tau + span, vec2(place.y, place.z), 2);
        w.s = 1.0f;
        w.side = 0.0f;
    }
    c.tau = tau;
    c.span = span;
    c.b = a.b;
    c.tx = a.tx;
    w.c = c;
    w.longest = 2.0f * span;
    // Towards the surface the first bounds to be asked for are those of half the chord.
    if (w.side * c.h.y < 0.0f) w.level = min(level_over(ob, 0.5f * texel_rate(c)), kPyramidLevels);
}

FUNC float height_on(Chord c, float s) { return c.h.x + s * (c.h.y + s * c.h.z); }
FUNC vec2 texel_on(Chord c, float s) { return c.tx + (c.d1 + c.d2 * s) * s; }
FUNC vec2 barycentrics_on(Chord c, float s) { return c.b + (c.b1 + c.b2 * s) * s; }

// Along the chord until a stretch under which the surface may be: from w.s to `to`, of the finest level. False at the
// chord's end.
FUNC bool seek_leaf(Primitive p, ObjectData ob, PrismRay r, float tolerance, INOUT(Walk) w, OUT(float) to) {
    Chord c = w.c;
    vec2 base = primitive_base(p);
    float texels = texel_rate(c);
    bool found = false, failed = false;
    int least = least_level(ob);
    do {
        float s = w.s;
        to = min(s + 0.9f * power_of_two(w.level) / texels, 1.0f);
        vec2 x0 = texel_on(c, s), x1 = texel_on(c, to);
        float part = 0.25f * (to - s) * (to - s);  // a quadratic's square coefficient bends it by this part of itself
        vec2 low = min(x0, x1) - abs(c.d2) * part - vec2(c.bend + 1e-3f);
        float h0 = height_on(c, s), h1 = height_on(c, to);
        note(kNoteStep, r.t0 + c.tau + c.span * s, x0, h0, (to - s) * texels);
        // All heights from here on are over the slab's plane.
        vec2 cell = floor(low);
        HeightSlab slab = height_slab(p.object, w.level, base + cell);
        vec2 slope = slab.slope * ob.amplitude, middle = cell + slab.middle;
        h0 -= dot(slope, x0 - middle);
        h1 -= dot(slope, x1 - middle);
        float sag = abs(c.h.z - dot(slope, c.d2)) * part + (abs(slope.x) + abs(slope.y)) * c.bend + c.error;
        float d0 = displacement(ob, slab.bounds.x), d1 = displacement(ob, slab.bounds.y);
        float top = max(d0, d1) + tolerance + sag, bottom = min(d0, d1) - tolerance - sag;
        bool above = min(h0, h1) > top, below = max(h0, h1) < bottom;
        bool passes = (above && w.side >= 0.0f) || (below && w.side <= 0.0f);
        // Else the ray may come between the bounds on its way: up to there it passes.
        bool falls = h0 > h1;
        float outside = falls ? h0 - top : bottom - h0;
        bool enters = outside > 0.0f && (falls ? w.side >= 0.0f : w.side <= 0.0f);
        w.s = passes ? to : s + (enters ? outside * (to - s) / abs(h0 - h1) : 0.0f);
        w.side = passes ? (above ? 1.0f : -1.0f) : enters ? (falls ? 1.0f : -1.0f) : w.side;
        found = !passes && w.level <= least;
        // Half of a stretch that did not pass is more likely the one that does not.
        w.level = clamp(w.level + (passes ? (failed ? 0 : 1) : -1), least, kPyramidLevels);
        failed = !passes;
        w.stretches += found ? 0 : 1;
    } while (!found && w.stretches < kMaxStretches && w.s < 1.0f);
    return found;
}

// The cells under the leaf, from w.s to `to`. `unsure`: the ray comes nearer to the surface, without a hit, than the
// chord's own error, and that is more than `sure`; then nothing is decided.
FUNC bool solve_leaf(Primitive p, ObjectData ob, Shell shell, PrismRay r, float t_min, float tolerance, vec3 margin,
                     float to, float sure, INOUT(Walk) w, OUT(bool) unsure, OUT(SurfaceHit) hit) {
    Chord c = w.c;
    vec2 base = primitive_base(p);
    float s = w.s, after = 0.0f, enough = kRest * abs(ob.amplitude) + 0.5f * tolerance;
    unsure = false;
    // Under the leaf the path is as good as straight.
    float part = 0.25f * (to - s) * (to - s), bend = max(abs(c.d2.x), abs(c.d2.y)) * part + c.bend;
    vec2 d = c.d1 + c.d2 * (s + to), tx = c.tx - c.d2 * (s * to);
    // Borders are counted, not found again from the position: on large maps that would round back into the last cell.
    vec2 x = tx + d * s, apart = abs(d), cell = floor(x);
    vec2 forward = vec2(d.x > 0.0f ? 1.0f : -1.0f, d.y > 0.0f ? 1.0f : -1.0f);
    vec2 across = vec2(1.0f / max(apart.x, 1e-12f), 1.0f / max(apart.y, 1e-12f));
    vec2 leave = vec2(apart.x > 1e-12f ? s + (d.x > 0.0f ? cell.x + 1.0f - x.x : x.x - cell.x) * across.x : 1e30f,
                      apart.y > 1e-12f ? s + (d.y > 0.0f ? cell.y + 1.0f - x.y : x.y - cell.y) * across.y : 1e30f);
    hit.t = 0.0f;
    hit.b = vec2(0.0f, 0.0f);
    bool counts = false, again;  // a root: as a hit
    int roots = 0;
    do {
        // Until a root, or the leaf's end.
        bool found = false;
        float root = 0.0f;
        vec4 quad = vec4(0.0f, 0.0f, 0.0f, 0.0f);
        vec3 g = vec3(0.0f, 0.0f, 0.0f);
        int cells = 0;
        do {
            float end = min(max(min(leave.x, leave.y), s), to);
            quad = height_quad(p.object, base + cell);
            float h = height_on(c, s);
            note(kNoteCell, r.t0 + c.tau + c.span * s, cell, h, r.t0 + c.tau + c.span * end);
            // Height over the patch along the chord, from s on.
            vec2 f = tx + d * s - cell;
            float kx = quad.y - quad.x, ky = quad.z - quad.x, kxy = quad.x - quad.y - quad.z + quad.w;
            g = vec3(h - displacement(ob, quad.x + kx * f.x + ky * f.y + kxy * f.x * f.y),
                     c.h.y + 2.0f * s * c.h.z - ob.amplitude * (kx * d.x + ky * d.y + kxy * (f.x * d.y + f.y * d.x)),
                     c.h.z - ob.amplitude * kxy * d.x * d.y);
            // A ray that enters on the surface, within rounding, may slide along it, and the neighbour does not know either.
            bool touches = w.side == 0.0f && r.from_side && abs(g.x) <= tolerance;
            if (w.side == 0.0f) w.side = g.x < 0.0f ? -1.0f : 1.0f;
            // What the path's bend may do to the height over this cell.
            float slopes = max(abs(kx), abs(quad.w - quad.z)) + max(abs(ky), abs(quad.w - quad.y));
            float error = 1.5f * bend * slopes * abs(ob.amplitude) + c.error;
            // The quadratic lies over the least of its three control points: mostly that is enough.
            float u = end - s, last = g.x + u * (g.y + u * g.z);
            if (touches || min(min(g.x * w.side, last * w.side), (g.x + 0.5f * u * g.y) * w.side) <= error) {
                root = touches ? min(1e-3f, 0.5f * u) : 0.0f;  // within the triangle's margin
                bool crossed = after == 0.0f && (g.x * w.side < 0.0f || touches);  // since the last cell's end
                found = crossed || first_root(g, after, u, root);
                // The least gap in the cell: at its start (its neighbour may have been flat, and sure of itself), at its end,
                // or where the quadratic turns.
                float turn = g.z * w.side > 0.0f ? clamp(-0.5f * g.y / g.z, after, u) : after;
                float gap = min(last * w.side, (g.x + turn * (g.y + turn * g.z)) * w.side);
                unsure = unsure || (!found && gap < error && error > sure);
            }
            if (!found) {
                after = 0.0f;
                s = end;
                if (leave.x < leave.y) {
                    cell.x += forward.x;
                    leave.x += across.x;
                } else {
                    cell.y += forward.y;
                    leave.y += across.y;
                }
            }
        } while (!found && ++cells < kMaxCells && s < to);
        again = found && !unsure;
        if (again) {
            float tau = c.tau + c.span * (s + root);
            vec2 b = barycentrics_on(c, s + root);
            float steep = abs(ob.amplitude) * (max(abs(quad.y - quad.x), abs(quad.w - quad.z)) +
                                               max(abs(quad.z - quad.x), abs(quad.w - quad.y)));
            float curve = (abs(c.h.z) + max(abs(c.d2.x), abs(c.d2.y)) * steep) / (c.span * c.span);
            float slope;
            bool met = polish(p, ob, shell, r, cell, quad, 0.1f * c.span, enough, curve, b, tau, slope);
            note(kNoteRoot, r.t0 + tau, texel_at(p, b), height_on(c, s + root), 0.0f);
            // Beyond the cell's borders other heights hold; where Newton's steps run wild, so do heights.
            vec2 met_at = texel_at(p, b), place = met_at - cell;
            float border = kBorder + 4e-7f * max(abs(met_at.x), abs(met_at.y));
            bool there = shell_gap(shell, r, tau, b) <= kThere * (p.q1x + p.q2.y) + tolerance;
            // The way out of the surface is not the way in: Newton's steps went past that.
            bool first = slope * w.side <= 0.0f;
            unsure = met && sure < 1e30f &&
                     !(there && first && min(place.x, place.y) >= -border && max(place.x, place.y) <= 1.0f + border);
            counts = !unsure && met && there && in_triangle(b, margin) && r.t0 + tau >= t_min && opaque_at(p, b);
            hit.t = r.t0 + tau;
            hit.b = b;
            // Else: behind the ray's start, beyond the triangle, in a hole.
            after = root + 1e-4f;
            w.side = g.x + after * (g.y + after * g.z) < 0.0f ? -1.0f : 1.0f;
        }
    } while (again && !unsure && !counts && ++roots < 3 * kMaxCells);
    if (!counts && !unsure) w.s = to;
    return counts;
}

FUNC bool intersect_surface(Primitive p, ObjectData ob, vec4 parameters, vec3 o, vec3 d, float t_min, float t_max,
                            float random, OUT(SurfaceHit) hit) {
    PrismRay r;
    hit.t = t_max;
    hit.b = vec2(0.0f, 0.0f);
    float rounding = rounding_of_ray(p, o);
    p = higher(p, rounding);
    float shared_margin = min(kEdgeMargin + rounding / min(p.q1x, p.q2.y), kMostEdgeMargin);
    vec3 margin = vec3((p.flags & kPrimitiveOpenEdge0) != 0u ? kOpenMargin : shared_margin,
                       (p.flags & (kPrimitiveOpenEdge0 << 1)) != 0u ? kOpenMargin : shared_margin,
                       (p.flags & (kPrimitiveOpenEdge0 << 2)) != 0u ? kOpenMargin : shared_margin);
    if (kSearch && (p.flags & kPrimitiveSearched) != 0u)
        return search_patches(p, primitive_normals(), ob, o, d, t_min, t_max, rounding, margin, hit);
    // The chords lie where they lie whatever t_max is: it only ends the walk. Else the picture would depend on the order
    // in which a ray meets triangles.
    if (!enter_prism(p, o, d, t_min, kRayEnd, shared_margin + p.shell_margin, r)) return false;
    float limit = t_max - r.t0;
    if (!(r.low <= limit + kEntryRounding * abs(t_max))) return false;
    Shell shell = make_shell(p);
    float tolerance = 1e-6f * abs(ob.amplitude) + 4e-7f * max(abs(p.w_low), abs(p.w_high)) + rounding;
    float sure = kSureError * abs(ob.amplitude) + tolerance;
    float least_span = max(kLeastSpan * (r.high - r.low), kSpanRounding * r.high);
    float most_error = kHeightError * abs(ob.amplitude) + tolerance;
    vec3 entry = prism_barycentrics(r, r.low);
    Walk w;
    w.end = chord_end(p, shell, r, r.low, vec2(entry.y, entry.z));
    w.c.tau = r.low;
    w.c.span = 0.0f;
    w.s = 1.0f;
    w.longest = 1e30f;
    w.level = least_level(ob);
    w.stretches = 0;
    // Through the top or the bottom of its own height range the side is known; else the first cell tells.
    w.side = r.from_side || r.from_inside ? 0.0f : (r.rise < 0.0f ? 1.0f : -1.0f);
    bool met = false, walks = r.low < r.high;
    int rounds = 0;
    do {
        if (walks && w.s >= 1.0f) start_chord(p, ob, shell, r, most_error, 0.1f * least_span, w);
        // Polishing moves a root by less than half its chord.
        walks = walks && !(w.c.tau + w.c.span * (w.s - 0.5f) > limit);
        if (walks && w.s < 1.0f) {
            float to = 1.0f;
            bool leaf = is_slanted(p) && w.s == 0.0f && texel_rate(w.c) <= kShortChord;
            if (!leaf) leaf = seek_leaf(p, ob, r, tolerance, w, to);
            if (leaf) {
                float side = w.side;
                bool unsure;
                met = solve_leaf(p, ob, shell, r, t_min, tolerance, margin, to, w.c.span > least_span ? sure : 1e30f, w, unsure,
                                 hit);
                if (unsure) {
                    // Too bent to tell whether the ray passes: a shorter chord from here on.
                    w.side = side;
                    w.longest = kRefinement * w.c.span;
                    w.c.tau += w.c.span * w.s;
                    w.end = shell_point(p, shell, r, w.c.tau, barycentrics_on(w.c, w.s), 1);
                    w.c.span = 0.0f;
                    w.s = 1.0f;
                }
            } else {
                w.s = 1.0f;
            }
        }
        walks = walks && !met && w.stretches < kMaxStretches && (w.s < 1.0f || w.c.tau + w.c.span < r.high);
    } while (walks && ++rounds < kMaxStretches);
    return met && hit.t <= t_max;
}

FUNC vec3 shading_normal(Primitive p, PrimitiveNormals n, ObjectData ob, vec4 parameters, vec2 b) {
    return displaced_normal(p, n, ob, b, parameters.x > 0.5f);
}
