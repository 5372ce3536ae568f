// Exact intersection with the canonical surface (ours; DESIGN.md section 4).
//
// The ray is followed through the triangle's shell by its tangent (geometry/shell.glsl). A stretch of at most 2^level
// texels is skipped when all of it stays above (or below) the bounds of the cells under it, from a min-max pyramid
// whose nodes overlap: one fetch bounds the two by two nodes that such a stretch can touch. The end of each stretch is
// evaluated, so how far the path leaves its tangent is known, and is added to the stretch. Where nothing can be
// skipped the cells are walked one by one; in a cell the height along the chord is a quadratic, solved, then polished
// by Newton on S itself. Based on quadtree displacement mapping (Drobot 2009) and tessellation-free displacement
// (Thonat and others 2021); the path, the overlap and the polish are ours.
//
// What side of the surface the ray is on is carried along: a walk that starts on the other side has crossed.
// Limits: a shell that folds inside one triangle (several b for one point) is followed on one sheet only; normals are
// held to a cosine of kLeastNormalCosine to the triangle's own.
//
// Parameters: x: correct_normals (0 or 1).
const int kMaxStretches = 16384;     // per triangle: beyond, the ray counts as a miss
const int kMaxCells = 6;             // a walk is at most 2 texels long
const int kStartLevel = 3;
const int kLeastLevel = -8;          // stretches shorter than a texel, where the path is sharply bent
const float kEdgeMargin = 1e-5f;     // barycentric: neighbours overlap by this, so that no ray slips between,
const float kOpenMargin = 1e-6f;     // at an edge without neighbour: beyond it stands nothing
const float kMostEdgeMargin = 1e-3f; // or by more where a far ray's rounding asks for it
const float kBend = 0.05f;           // texels that a walked path may leave its chord,
const float kChordError = 2e-3f;     // and what that may do to the height, of the amplitude
const float kSeekSteps = 64.0f;      // of a path that looks for the way out of a fold
const float kFirmBend = 0.1f;        // barycentric: beyond, one Newton step at a stretch's end is not trusted

FUNC float displacement(ObjectData ob, float value) { return ob.amplitude * (value - ob.midlevel); }

FUNC bool in_triangle(vec2 b, vec3 margin) {
    return b.x >= -margin.y && b.y >= -margin.z && 1.0f - b.x - b.y >= -margin.x;
}

// The whole stretch lies outside the triangle, beyond one of its edges.
FUNC bool stretch_outside(vec2 a, vec2 e, float bend, vec3 margin) {
    vec3 ba = vec3(1.0f - a.x - a.y, a.x, a.y), be = vec3(1.0f - e.x - e.y, e.x, e.y);
    vec3 m = max(ba, be) + vec3(bend) + margin;
    return min(min(m.x, m.y), m.z) < 0.0f;
}

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

// Newton on S along the ray, in the bilinear patch of one cell, from a root on the chord. `rest` is the height that was
// left before the last step: not small where no root is near.
FUNC ShellPoint polish(Primitive p, ObjectData ob, Shell s, PrismRay r, vec2 cell, vec4 quad, vec2 guess, float reach,
                       INOUT(float) tau, OUT(float) rest) {
    ShellPoint a;
    for (int i = 0;; ++i) {
        a = shell_point(p, s, r, tau, guess, i == 0 ? 2 : 1);
        if (i == 2) return a;
        vec2 f = a.tx - cell;
        float gx = (quad.y - quad.x) * (1.0f - f.y) + (quad.w - quad.z) * f.y;
        float gy = (quad.z - quad.x) * (1.0f - f.x) + (quad.w - quad.y) * f.x;
        float slope = a.dh - ob.amplitude * (gx * a.dtx.x + gy * a.dtx.y);
        float gap = a.h - displacement(ob, bilinear(quad, f));
        rest = abs(gap);
        float step_back = slope != 0.0f ? clamp(gap / slope, -reach, reach) : 0.0f;
        tau -= step_back;
        guess = a.b - a.db * step_back;
    }
}

// Walks the cells under the chord from a (at tau) to e (span later). `side` is the side of the surface the ray is on.
FUNC bool walk_cells(Primitive p, ObjectData ob, Shell s, PrismRay r, ShellPoint a, ShellPoint e, float tau, float span,
                     float t_min, float tolerance, vec3 margin, INOUT(float) side, OUT(SurfaceHit) hit) {
    ivec2 base = primitive_base(p.base);
    vec2 d = e.tx - a.tx;
    float dh = e.h - a.h;
    // Borders are counted, not found again from the position: on large maps that would round back into the last cell.
    vec2 forward = vec2(d.x > 0.0f ? 1.0f : -1.0f, d.y > 0.0f ? 1.0f : -1.0f);
    vec2 cell = floor(a.tx), apart = abs(d);
    vec2 leave = vec2(apart.x > 1e-12f ? (d.x > 0.0f ? cell.x + 1.0f - a.tx.x : a.tx.x - cell.x) / apart.x : 1e30f,
                      apart.y > 1e-12f ? (d.y > 0.0f ? cell.y + 1.0f - a.tx.y : a.tx.y - cell.y) / apart.y : 1e30f);
    vec2 across = vec2(1.0f / max(apart.x, 1e-12f), 1.0f / max(apart.y, 1e-12f));
    float from = 0.0f;
    hit.t = 0.0f;
    hit.b = vec2(0.0f, 0.0f);
    for (int i = 0; i < kMaxCells; ++i) {
        float to = min(max(min(leave.x, leave.y), from), 1.0f);
        note(kNoteCell, r.t0 + tau + span * from, cell, a.h + dh * from, r.t0 + tau + span * to);
        vec4 quad = height_quad(p.object, base + ivec2(cell));
        // Height over the patch along the chord, from s = `from` on.
        vec2 f = a.tx + d * from - cell;
        float kx = quad.y - quad.x, ky = quad.z - quad.x, kxy = quad.x - quad.y - quad.z + quad.w;
        vec3 c = vec3(a.h + dh * from - displacement(ob, quad.x + kx * f.x + ky * f.y + kxy * f.x * f.y),
                      dh - ob.amplitude * (kx * d.x + ky * d.y + kxy * (f.x * d.y + f.y * d.x)),
                      -ob.amplitude * kxy * d.x * d.y);
        float root = 0.0f, after = 0.0f;
        for (int k = 0; k < 3; ++k) {
            bool crossed = k == 0 && c.x * side < 0.0f;  // since the last cell's end
            if (!crossed && !first_root(c, after, to - from, root)) break;
            float at = tau + span * (from + root);
            vec2 guess = a.b + (e.b - a.b) * (from + root);
            float rest = 0.0f;
            ShellPoint h = polish(p, ob, s, r, cell, quad, guess, 0.1f * span, at, rest);
            note(kNoteRoot, r.t0 + at, h.tx, h.h, 0.0f);
            if (rest <= kChordError * abs(ob.amplitude) + tolerance && in_triangle(h.b, margin) && r.t0 + at >= t_min && opaque_at(p, h.b)) {
                hit.t = r.t0 + at;
                hit.b = h.b;
                return true;
            }
            side = -side;
            after = root + 1e-4f;
        }
        from = to;
        if (from >= 1.0f) break;
        if (leave.x < leave.y) {
            cell.x += forward.x;
            leave.x += across.x;
        } else {
            cell.y += forward.y;
            leave.y += across.y;
        }
    }
    return false;
}

FUNC bool intersect_surface(Primitive p, ObjectData ob, vec4 parameters, vec3 o, vec3 d, float t_min, float t_max,
                            float random, OUT(SurfaceHit) hit) {
    PrismRay r;
    hit.t = t_max;
    hit.b = vec2(0.0f, 0.0f);
    // What rounding of a far ray may take from a flat triangle's range.
    vec3 away = abs(o - p.origin);
    float rounding = 3e-7f * max(max(away.x, away.y), away.z);
    p.w_low -= rounding;
    p.w_high += rounding;
    float shared_margin = min(kEdgeMargin + rounding / min(p.q1x, p.q2.y), kMostEdgeMargin);
    vec3 margin = vec3((p.flags & kPrimitiveOpenEdge0) != 0u ? kOpenMargin : shared_margin,
                       (p.flags & (kPrimitiveOpenEdge0 << 1)) != 0u ? kOpenMargin : shared_margin,
                       (p.flags & (kPrimitiveOpenEdge0 << 2)) != 0u ? kOpenMargin : shared_margin);
    if (!enter_shell(p, o, d, t_min, t_max, shared_margin, r)) return false;
    Shell s = make_shell(p);
    float tau = r.low;
    ShellPoint a;
    a.h = 0.0f;
    a.tx = vec2(0.0f, 0.0f);
    // Through the top or the bottom of its own height range the side is known; else it is looked up when needed.
    float side = r.from_side || r.from_inside ? 0.0f : (r.wd < 0.0f ? 1.0f : -1.0f);
    float tolerance = 1e-6f * abs(ob.amplitude) + 4e-7f * max(abs(p.w_low), abs(p.w_high)) + rounding;
    ivec2 base = primitive_base(p.base);
    bool folded = (p.flags & kPrimitiveFolded) != 0u, lost = true, sought = false;
    float coarse = (r.high - r.low) / kSeekSteps, stride = coarse;
    float highest = 1.02f * max(abs(p.w_low), abs(p.w_high));
    int level = kStartLevel;
    for (int i = 0; i < kMaxStretches && tau < r.high; ++i) {
        if (folded && !(abs(a.h) <= highest)) lost = true;
        // One place for all points of the path: they are most of this shader's code.
        float reach = exp2(float(level));
        float end = lost ? tau : min(tau + 0.9f * reach / max(max(abs(a.dtx.x), abs(a.dtx.y)), 1e-20f), r.high);
        float span = end - tau;
        vec2 guess = lost ? guess_shell_point(p, s, r, tau) : a.b + a.db * span;
        note(kNoteStep, r.t0 + tau, a.tx, a.h, reach);
        ShellPoint e = shell_point(p, s, r, end, guess, lost ? (folded ? 4 : 2) : 1);
        // Higher than the surface's own heights there may be folds of the shell: on to where the ray leaves them.
        // They are sought in two rounds, the second where the first came into them.
        if (folded && lost && !(abs(e.h) <= highest)) {
            tau = end + stride;
            sought = true;
            side = 0.0f;
            continue;
        }
        if (lost && sought && stride == coarse) {
            tau = end - stride;
            stride = coarse / kSeekSteps;
            tau += stride;
            continue;
        }
        if (lost) {
            a = e;
            lost = false;
            sought = false;
            stride = coarse;
            if (!in_triangle(a.b, margin)) side = 0.0f;
            continue;
        }
        vec2 off = abs(e.tx - a.tx - a.dtx * span);
        float bend = 0.5f * max(off.x, off.y), bend_h = 0.5f * abs(e.h - a.h - a.dh * span);
        // A node of the pyramid holds any stretch of its level's length that begins in it.
        vec2 low = min(a.tx, e.tx) - vec2(bend + 1e-3f), extent = max(a.tx, e.tx) + vec2(bend + 1e-3f) - low;
        float most = max(reach, 2.0f);
        bool held = extent.x <= most && extent.y <= most;  // false for NaN as well
        vec2 off_b = abs(e.b - a.b - a.db * span);
        bool firm = held && off_b.x <= kFirmBend && off_b.y <= kFirmBend;
        if (!firm && level > kLeastLevel) {
            --level;
            continue;
        }
        if (!held || stretch_outside(a.b, e.b, 0.5f * max(off_b.x, off_b.y), margin)) {
            tau = end > tau ? end : r.high;
            a = e;
            lost = !held;
            side = 0.0f;
            level = min(level + 1, kPyramidLevels);
            continue;
        }
        if (side == 0.0f)
            side = a.h >= displacement(ob, map_value(p.object, base, a.tx)) ? 1.0f : -1.0f;
        vec2 bounds = map_bounds(p.object, max(level, 1), base + ivec2(floor(low)));
        float d0 = displacement(ob, bounds.x), d1 = displacement(ob, bounds.y);
        bool clear = side > 0.0f ? min(a.h, e.h) - bend_h > max(d0, d1) + tolerance
                                 : max(a.h, e.h) + bend_h < min(d0, d1) - tolerance;
        if (clear) {
            tau = end;
            a = e;
            level = min(level + 1, kPyramidLevels);
            continue;
        }
        bool bent = bend > kBend || bend * abs(d1 - d0) + bend_h > kChordError * abs(ob.amplitude);
        if (level > 1 || (bent && level > kLeastLevel)) {
            --level;
            continue;
        }
        if (walk_cells(p, ob, s, r, a, e, tau, span, t_min, tolerance, margin, side, hit)) return hit.t <= t_max;
        tau = end > tau ? end : r.high;
        a = e;
    }
    return false;
}

FUNC vec3 shading_normal(Primitive p, PrimitiveNormals n, ObjectData ob, vec4 parameters, vec2 b) {
    return displaced_normal(p, n, ob, b, parameters.x > 0.5f);
}
