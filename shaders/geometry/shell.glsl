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

// How far the shell coordinates b lead beside the ray's point at tau, in the frame's plane.
FUNC float shell_gap(Shell s, PrismRay r, float tau, vec2 b) {
    vec2 mu = (s.nu0 + s.nu1 * b.x + s.nu2 * b.y) * (1.0f / (s.k0 + s.k1 * b.x + s.k2 * b.y));
    vec2 f = abs(s.q1 * b.x + s.q2 * b.y + mu * (r.w0 + r.wd * tau) - r.x0 - r.xd * tau);
    return max(f.x, f.y);
}

#endif
