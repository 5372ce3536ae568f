// Marching: the plain baseline that thesis 000 compares with (its figure 6.3, "a fixed step size and a maximum of 300
// steps per ray").
//
// The ray is sampled at a fixed step in world space through the hull of the triangle's part of S; the first change of
// sides between two samples is refined linearly. A sample's place on the base triangle is that of the true shell,
// P(b) + h N(b), as in the method `exact`: the surface marched is S itself, and neighbours agree along their edge (the
// thesis says nothing of meshes with curved shells). Further deviations:
//  - the step follows from the count, as the diameter of the object's bounding sphere over it, instead of being another
//    parameter: no ray ends before it has crossed its prism;
//  - the prism's entry and exit are samples too, so that no crossing between the last sample of one and the first of
//    its neighbour is skipped.
// Where the shell folds, Newton's steps from one sample to the next follow one sheet of it, or none.
//
// Parameters: x: steps (a bounding sphere's diameter), y: correct_normals (0 or 1).
const uint kMaxSteps = 16384u;        // a path is cut into at most this many
const float kSharedMargin = 1e-5f;    // barycentric: neighbours overlap by this (more would leave the triangles' boxes),
const float kOpenMargin = 2e-7f;      // but nothing stands beyond an edge without neighbour
const float kMostResidual = 1e-3f;    // of the triangle's size: how far off its place a sample may be that counts

struct MarchSample {
    ShellPoint at;
    float tau, gap;  // gap: height over the surface, world units
    bool sound;      // it has a place on the shell
};

FUNC bool is_within(vec2 b, vec3 margin) {
    return b.x >= -margin.y && b.y >= -margin.z && 1.0f - b.x - b.y >= -margin.x;
}

// How far the shell's point is beside the ray's, in the frame's plane.
FUNC float shell_residual(Shell s, PrismRay r, float tau, vec2 b) {
    float k = s.k0 + s.k1 * b.x + s.k2 * b.y;
    vec2 mu = (s.nu0 + s.nu1 * b.x + s.nu2 * b.y) * (1.0f / k);
    vec2 off = s.q1 * b.x + s.q2 * b.y + mu * (r.w0 + r.wd * tau) - r.x0 - r.xd * tau;
    return max(abs(off.x), abs(off.y));
}

FUNC MarchSample march_sample(Primitive p, ObjectData ob, Shell s, PrismRay r, float tau, vec2 guess, int steps) {
    MarchSample m;
    m.tau = tau;
    m.at = shell_point(p, s, r, tau, guess, steps);
    m.sound = abs(m.at.b.x) < 2.0f && abs(m.at.b.y) < 2.0f;  // false for NaN
    if (kSearch && (p.flags & kPrimitiveSearched) != 0u)
        m.sound = m.sound && shell_residual(s, r, tau, m.at.b) <= kMostResidual * max(p.q1x, p.q2.y);
    m.gap = m.sound ? m.at.h - displacement_at(p, ob, m.at.b) : 0.0f;
    note(kNoteStep, r.t0 + tau, m.at.tx, m.at.h, 0.0f);
    return m;
}

// The ray's stretch beside a triangle whose prism is no guide: within a box in the triangle's frame that holds S, whose
// points are at most the greatest displacement away from the base triangle.
FUNC bool enter_frame_box(Primitive p, vec3 o, vec3 d, float t_min, OUT(PrismRay) r) {
    float reach = max(abs(p.w_low), abs(p.w_high));
    vec3 bitangent = frame_bitangent(p), from = o - p.origin;
    vec3 x = vec3(dot(from, p.tangent), dot(from, bitangent), dot(from, p.ng));
    vec3 xd = vec3(dot(d, p.tangent), dot(d, bitangent), dot(d, p.ng));
    vec3 inverse = 1.0f / vec3(abs(xd.x) > 1e-20f ? xd.x : 1e-20f, abs(xd.y) > 1e-20f ? xd.y : 1e-20f,
                               abs(xd.z) > 1e-20f ? xd.z : 1e-20f);
    vec3 a = (vec3(min(p.q2.x, 0.0f), 0.0f, 0.0f) - vec3(reach) - x) * inverse;
    vec3 b = (vec3(max(p.q2.x, p.q1x), p.q2.y, 0.0f) + vec3(reach) - x) * inverse;
    vec3 enter = min(a, b), leave = max(a, b);
    r.t0 = max(max(enter.x, enter.y), max(enter.z, t_min));
    r.low = 0.0f;
    r.high = min(min(leave.x, leave.y), leave.z) - r.t0;
    r.x0 = vec2(x.x, x.y) + vec2(xd.x, xd.y) * r.t0;
    r.xd = vec2(xd.x, xd.y);
    r.w0 = x.z + xd.z * r.t0;
    r.wd = xd.z;
    return r.high >= 0.0f;
}

// The vertex normals themselves: a primitive's shifts are held back where a normal leans far.
FUNC Shell full_shell(Primitive p, PrimitiveNormals n) {
    Shell s = make_shell(p);
    vec3 bitangent = frame_bitangent(p), n1 = n.n1 - n.n0, n2 = n.n2 - n.n0;
    s.nu0 = vec2(dot(n.n0, p.tangent), dot(n.n0, bitangent));
    s.nu1 = vec2(dot(n1, p.tangent), dot(n1, bitangent));
    s.nu2 = vec2(dot(n2, p.tangent), dot(n2, bitangent));
    s.k0 = dot(n.n0, p.ng);
    s.k1 = dot(n1, p.ng);
    s.k2 = dot(n2, p.ng);
    return s;
}

// First hit in [t_min, t_max] that is not a hole of the opacity map. The samples lie where they lie whatever t_max is.
FUNC bool intersect_surface(Primitive p, ObjectData ob, vec4 parameters, vec3 o, vec3 d, float t_min, float t_max,
                            float random, OUT(SurfaceHit) hit) {
    PrismRay r;
    Shell s = make_shell(p);
    vec2 guess;
    hit.t = t_max;
    hit.b = vec2(0.0f, 0.0f);
    bool searched = kSearch && (p.flags & kPrimitiveSearched) != 0u;
    if (searched) {
        s = full_shell(p, primitive_normals());
        if (!enter_frame_box(p, o, d, t_min, r)) return false;
        guess = vec2(1.0f / 3.0f, 1.0f / 3.0f);
    } else {
        if (!enter_prism(higher(p, rounding_of_ray(p, o)), o, d, t_min, kRayEnd, kSharedMargin + p.shell_margin, r)) return false;
        vec3 entry = prism_barycentrics(r, r.low);
        guess = vec2(entry.y, entry.z);
    }
    float limit = t_max - r.t0;
    if (!(r.low <= limit)) return false;
    vec3 margin = vec3((p.flags & kPrimitiveOpenEdge0) != 0u ? kOpenMargin : kSharedMargin,
                       (p.flags & (kPrimitiveOpenEdge0 << 1)) != 0u ? kOpenMargin : kSharedMargin,
                       (p.flags & (kPrimitiveOpenEdge0 << 2)) != 0u ? kOpenMargin : kSharedMargin);
    float step_length = max(2.0f * ob.radius / parameters.x, (r.high - r.low) / float(kMaxSteps - 2u));
    MarchSample last = march_sample(p, ob, s, r, r.low, guess, searched ? 4 : 2);
    for (uint i = 0u; i < kMaxSteps && last.tau < r.high && last.tau <= limit; ++i) {
        float tau = min(last.tau + step_length, r.high), span = tau - last.tau;
        MarchSample next = march_sample(p, ob, s, r, tau, last.sound ? last.at.b + last.at.db * span : guess, 2);
        if (last.sound && next.sound && last.gap * next.gap <= 0.0f && last.gap != next.gap) {
            float part = clamp(last.gap / (last.gap - next.gap), 0.0f, 1.0f);
            vec2 b = last.at.b + (next.at.b - last.at.b) * part;
            float t = r.t0 + last.tau + span * part;
            note(kNoteRoot, t, texel_at(p, b), 0.0f, 0.0f);
            if (is_within(b, margin) && opaque_at(p, b)) {
                hit.t = t;
                hit.b = b;
                return t >= t_min && t <= t_max;
            }
        }
        last = next;
    }
    return false;
}

FUNC vec3 shading_normal(Primitive p, PrimitiveNormals n, ObjectData ob, vec4 parameters, vec2 b) {
    return displaced_normal(p, n, ob, b, parameters.y > 0.5f);
}
