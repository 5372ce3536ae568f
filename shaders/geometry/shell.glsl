// The true shell of the canonical surface, P(b) + h N(b), followed along a ray in the triangle's frame.
//
// With w the height along Ng (linear in t), h = w / k(b), k(b) = sum b_i N_i.Ng, the ray's point x(t) in the frame's
// plane is q(b) + w nu(b) / k(b), nu the lateral part of N: two equations in b, solved by Newton from a near guess.
// (DESIGN.md section 4. The parallel offset prism replaces nu(b) / k(b) by sum b_i nu_i / k_i: a good first guess.)
#ifndef RELIEVO_SHELL_GLSL
#define RELIEVO_SHELL_GLSL

struct Shell {
    vec2 q1, q2;           // base triangle in the frame's plane, q0 = 0
    vec2 nu0, nu1, nu2;    // lateral parts of the vertex normals; nu1 and nu2 as differences to nu0
    float k0, k1, k2;      // their cosines to Ng; k1 and k2 as differences to k0
};

// How far the surface may stand beside the base triangle: |D| sin of the greatest angle between N_i and Ng.
FUNC float shell_reach(Primitive p) {
    float most = max(max(dot(p.shift0, p.shift0), dot(p.shift1, p.shift1)), dot(p.shift2, p.shift2));
    return max(abs(p.w_low), abs(p.w_high)) * sqrt(most / (1.0f + most));
}

struct ShellPoint {
    vec2 b, db;    // barycentrics of vertices 1 and 2, and per unit of tau
    vec2 tx, dtx;  // texel coordinates relative to the primitive's base
    float h, dh;   // height along the unit interpolated normal, world units: comparable with D
};

FUNC Shell make_shell(Primitive p) {
    Shell s;
    s.q1 = vec2(p.q1x, 0.0f);
    s.q2 = p.q2;
    s.k0 = 1.0f / sqrt(1.0f + dot(p.shift0, p.shift0));
    float k1 = 1.0f / sqrt(1.0f + dot(p.shift1, p.shift1)), k2 = 1.0f / sqrt(1.0f + dot(p.shift2, p.shift2));
    s.nu0 = p.shift0 * s.k0;
    s.nu1 = p.shift1 * k1 - s.nu0;
    s.nu2 = p.shift2 * k2 - s.nu0;
    s.k1 = k1 - s.k0;
    s.k2 = k2 - s.k0;
    return s;
}

// Enters a part of space that holds the triangle's shell: the parallel prism, widened, or, where that is folded or
// differs much from the shell, the slab of its heights with the base triangle's sides moved out by the farthest that
// the surface can reach to the side.
FUNC bool enter_shell(Primitive p, vec3 o, vec3 d, float t_min, float t_max, float margin, OUT(PrismRay) r) {
    if ((p.flags & kPrimitiveFolded) == 0u) return enter_prism(p, o, d, t_min, t_max, margin + p.shell_margin, r);
    if (!enter_prism(p, o, d, t_min, t_max, margin, r)) return false;
    vec2 q1 = vec2(p.q1x, 0.0f);
    float reach = shell_reach(p) + margin * p.q1x;
    vec3 n = vec3(cross2(q1 - r.x0, p.q2 - r.x0), cross2(p.q2 - r.x0, -r.x0), cross2(-r.x0, q1 - r.x0));
    vec3 dn = vec3(cross2(p.q2 - q1, r.xd), cross2(-p.q2, r.xd), cross2(q1, r.xd));
    n = n + vec3(length(p.q2 - q1), length(p.q2), p.q1x) * reach;
    for (int i = 0; i < 3; ++i) {
        if (dn[i] > 0.0f) r.low = max(r.low, -n[i] / dn[i]);
        else if (dn[i] < 0.0f) r.high = min(r.high, -n[i] / dn[i]);
        else if (n[i] < 0.0f) return false;
    }
    r.from_side = true;
    return r.low <= r.high;
}

// The shell's coordinates of the ray's point at tau, by `steps` Newton steps from `guess`. NaN or far off where the
// shell folds: callers check.
FUNC ShellPoint shell_point(Primitive p, Shell s, PrismRay r, float tau, vec2 guess, int steps) {
    ShellPoint a;
    a.b = guess;
    float w = r.w0 + r.wd * tau;
    vec2 x = r.x0 + r.xd * tau;
    vec2 mu = vec2(0.0f, 0.0f), j1 = vec2(1.0f, 0.0f), j2 = vec2(0.0f, 1.0f);
    float inverse_k = 1.0f, inverse_det = 1.0f;
    for (int i = 0; i <= steps; ++i) {
        inverse_k = 1.0f / (s.k0 + s.k1 * a.b.x + s.k2 * a.b.y);
        mu = (s.nu0 + s.nu1 * a.b.x + s.nu2 * a.b.y) * inverse_k;
        if (i == steps) break;
        vec2 f = s.q1 * a.b.x + s.q2 * a.b.y + mu * w - x;
        float g = w * inverse_k;
        j1 = s.q1 + (s.nu1 - mu * s.k1) * g;
        j2 = s.q2 + (s.nu2 - mu * s.k2) * g;
        inverse_det = 1.0f / cross2(j1, j2);
        a.b = a.b - vec2(cross2(f, j2), cross2(j1, f)) * inverse_det;
    }
    vec2 ft = mu * r.wd - r.xd;
    a.db = vec2(-cross2(ft, j2), -cross2(j1, ft)) * inverse_det;
    vec2 t1 = p.tx1 - p.tx0, t2 = p.tx2 - p.tx0;
    a.tx = p.tx0 + t1 * a.b.x + t2 * a.b.y;
    a.dtx = t1 * a.db.x + t2 * a.db.y;
    vec2 dmu = (s.nu1 * a.db.x + s.nu2 * a.db.y - mu * (s.k1 * a.db.x + s.k2 * a.db.y)) * inverse_k;
    float l = sqrt(1.0f + dot(mu, mu));
    a.h = w * l;
    a.dh = r.wd * l + w * dot(mu, dmu) / l;
    return a;
}

// A guess for shell_point where there is no neighbouring point.
FUNC vec2 guess_shell_point(Primitive p, Shell s, PrismRay r, float tau) {
    if ((p.flags & kPrimitiveFolded) == 0u) {
        vec3 b = prism_barycentrics(r, tau);
        return vec2(b.y, b.z);
    }
    // From the projection along Ng, held near the triangle, by Newton steps that keep the height within the
    // surface's own: beyond, the shell may fold.
    vec2 x = r.x0 + r.xd * tau;
    float w = r.w0 + r.wd * tau, most = max(abs(p.w_low), abs(p.w_high));
    float b2 = clamp(x.y / p.q2.y, 0.0f, 1.0f);
    vec2 b = vec2(clamp((x.x - p.q2.x * b2) / p.q1x, 0.0f, 1.0f - b2), b2);
    for (int i = 0; i < 6; ++i) {
        float k = s.k0 + s.k1 * b.x + s.k2 * b.y;
        vec2 nu = s.nu0 + s.nu1 * b.x + s.nu2 * b.y;
        float h = clamp(w / max(k, 1e-3f), -most, most) / sqrt(k * k + dot(nu, nu));
        vec2 f = s.q1 * b.x + s.q2 * b.y + nu * h - x, j1 = s.q1 + s.nu1 * h, j2 = s.q2 + s.nu2 * h;
        b = b - vec2(cross2(f, j2), cross2(j1, f)) * (1.0f / cross2(j1, j2));
        b = clamp(b, vec2(-0.5f), vec2(1.5f));
    }
    return b;
}

#endif
