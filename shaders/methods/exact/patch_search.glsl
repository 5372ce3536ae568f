// First hit with S over one triangle whose shell folds over itself or stands far from the triangle's normal, where the
// path of a ray through the shell is torn: by subdivision of the base triangle with bounds, as renderer/reference does
// it in double, in single precision and with bounds that are cheap.
//
// A patch is a square of barycentrics. Over it S = P + D N/|N| lies in the hull of P_i + D_low N_i/l and P_i + D_high N_i/l
// at its corners, l the middle of the lengths that N takes, grown by max|D| (l_high - l_low)/(l_high + l_low). Patches
// whose box (along the ray and across it) the ray misses are dropped. A patch of at most a texel over which N hardly turns
// is solved by Newton on S, cell by cell, so that what is solved is smooth; where the Jacobian says that there may be a
// second root, it is divided on. No stack: the patch's place among those of its depth is a Morton code.
const int kMaxPatches = 32768;       // a triangle: beyond, the best of what was found counts
const int kPatchDepth = 15;
const float kPatchTexels = 1.0f;     // of a patch that is solved
const float kPatchTurn = 0.15f;      // and how far its unit normals may turn, radians
const float kLeastLength = 0.05f;    // of N: below, it is taken to point anywhere
const int kPatchSteps = 8;           // of Newton
const float kLeastPatch = 1e-4f;     // size of a patch that is not divided, of the greatest displacement
const float kSameSheet = 0.4f;       // the Jacobian's determinant keeps this part of itself where one root stands alone

struct PatchFrame {      // the triangle as the ray sees it: x and y across, z along it from its origin
    vec3 p, p1, p2;      // base triangle: p + b1 p1 + b2 p2
    vec3 n, n1, n2;      // its normals, likewise
    vec2 tx, tx1, tx2;   // texels relative to the primitive's base
};

struct PatchBox {
    vec3 low, high;      // the ray's frame
};

struct PatchRoot {
    vec2 b;
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
    vec3 from = p.origin - o, e1 = base_edge1(p), e2 = base_edge2(p), m1 = n.n1 - n.n0, m2 = n.n2 - n.n0;
    PatchFrame f;
    f.p = vec3(dot(from, x), dot(from, y), dot(from, d));
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

// The texels that the patch covers.
FUNC void patch_texels(PatchFrame f, vec2 corner, float side, OUT(vec2) low, OUT(vec2) high) {
    vec2 a = patch_texel(f, corner);
    low = a + side * (min(f.tx1, vec2(0.0f)) + min(f.tx2, vec2(0.0f)));
    high = a + side * (max(f.tx1, vec2(0.0f)) + max(f.tx2, vec2(0.0f)));
}

// Least and greatest displacement over the patch, which covers the texels from `low` to `high`.
FUNC vec2 patch_displacement(Primitive p, ObjectData ob, vec2 low, vec2 high) {
    vec2 extent = high - low + vec2(2e-3f), cell = floor(low);
    float most = max(extent.x, extent.y);
    if (most > power_of_two(kPyramidLevels)) return vec2(p.w_low, p.w_high);
    vec2 base = primitive_base(p);
    vec2 values;
    if (cell.x == floor(high.x) && cell.y == floor(high.y)) {
        // Within one cell the extremes of a bilinear height are at the corners.
        vec4 quad = height_quad(p.object, base + cell);
        vec2 f0 = low - cell, f1 = high - cell;
        float v0 = bilinear(quad, f0), v1 = bilinear(quad, vec2(f1.x, f0.y)), v2 = bilinear(quad, vec2(f0.x, f1.y)),
              v3 = bilinear(quad, f1);
        values = vec2(min(min(v0, v1), min(v2, v3)), max(max(v0, v1), max(v2, v3)));
    } else {
        int level = most <= 2.0f ? 1 : int(ceil(log2(most)));
        values = map_bounds(p.object, level, base + floor(low - vec2(1e-3f)));
    }
    float d0 = displacement(ob, values.x), d1 = displacement(ob, values.y);
    return vec2(max(min(d0, d1), p.w_low), min(max(d0, d1), p.w_high));
}

FUNC void hold(vec3 base, vec3 normal, vec2 d, INOUT(vec3) low, INOUT(vec3) high) {
    vec3 a = base + normal * d.x, b = base + normal * d.y;
    low = min(low, min(a, b));
    high = max(high, max(a, b));
}

FUNC PatchBox patch_box(PatchFrame f, vec2 corner, float side, vec2 d) {
    vec3 n0 = f.n + f.n1 * corner.x + f.n2 * corner.y, n1 = f.n1 * side, n2 = f.n2 * side;
    vec3 p0 = f.p + f.p1 * corner.x + f.p2 * corner.y, p1 = f.p1 * side, p2 = f.p2 * side;
    float spread = 0.5f * max(length(n1 + n2), length(n1 - n2)), middle = length(n0 + (n1 + n2) * 0.5f);
    float shortest = middle - spread, longest = max(max(length(n0), length(n0 + n1)), max(length(n0 + n2), length(n0 + n1 + n2)));
    float most = max(abs(d.x), abs(d.y));
    bool pointed = shortest > kLeastLength;
    float scale = pointed ? 2.0f / (shortest + longest) : 0.0f;
    vec3 radius = vec3(most * (pointed ? (longest - shortest) * 0.5f * scale : 1.0f));
    vec2 range = d * scale;
    PatchBox box;
    box.low = vec3(1e30f);
    box.high = vec3(-1e30f);
    hold(p0, n0, range, box.low, box.high);
    hold(p0 + p1, n0 + n1, range, box.low, box.high);
    hold(p0 + p2, n0 + n2, range, box.low, box.high);
    hold(p0 + p1 + p2, n0 + n1 + n2, range, box.low, box.high);
    box.low = box.low - radius;
    box.high = box.high + radius;
    return box;
}

FUNC bool box_met(PatchBox box, float rounding, float z_min, float z_max) {
    return max(box.low.x, box.low.y) <= rounding && min(box.high.x, box.high.y) >= -rounding &&
           box.low.z - rounding <= z_max && box.high.z + rounding >= z_min;
}

// Newton on S across the ray from the patch's middle, over one cell's bilinear heights.
FUNC PatchRoot solve_patch(Primitive p, ObjectData ob, PatchFrame f, vec2 corner, float side, vec2 cell, float rounding) {
    PatchRoot root;
    vec2 middle = corner + vec2(0.5f * side), b = middle;
    vec4 q = height_quad(p.object, primitive_base(p) + cell);
    float first = 0.0f, slack = 0.5e-3f * side + 1e-6f;
    bool at_border = false;
    root.b = b;
    root.z = 0.0f;
    root.inside = false;
    root.decided = false;
    for (int i = 0; i < kPatchSteps; ++i) {
        vec2 at = patch_texel(f, b) - cell, g = bilinear_gradient(q, at);
        vec3 n = f.n + f.n1 * b.x + f.n2 * b.y;
        float inverse = 1.0f / max(length(n), 1e-20f), d = displacement(ob, bilinear(q, at));
        vec3 u = n * inverse, s = f.p + f.p1 * b.x + f.p2 * b.y + u * d;
        vec3 s1 = f.p1 + (f.n1 - u * dot(u, f.n1)) * (inverse * d) + u * (ob.amplitude * dot(g, f.tx1));
        vec3 s2 = f.p2 + (f.n2 - u * dot(u, f.n2)) * (inverse * d) + u * (ob.amplitude * dot(g, f.tx2));
        float det = cross2(vec2(s1.x, s1.y), vec2(s2.x, s2.y));
        if (i == 0) first = det;
        bool alone = det * first > 0.0f && abs(det) > kSameSheet * abs(first) && abs(first) > kSameSheet * abs(det);
        vec2 change = vec2(s.x * s2.y - s.y * s2.x, s1.x * s.y - s1.y * s.x) * (-1.0f / det);
        vec2 target = b + change, off = abs(target - middle);
        if (!(max(off.x, off.y) <= 1e6f)) return root;  // NaN too
        // Within rounding of the ray's place, or of the barycentrics'.
        if (max(abs(s.x), abs(s.y)) <= 0.25f * rounding || max(abs(change.x), abs(change.y)) <= 1e-7f) {
            root.b = target;
            root.z = s.z + s1.z * change.x + s2.z * change.y;
            vec2 place = patch_texel(f, target) - cell;
            root.inside = max(off.x, off.y) <= 0.5f * side + slack && min(place.x, place.y) >= -1e-3f &&
                          max(place.x, place.y) <= 1.001f;
            root.decided = alone;
            return root;
        }
        // From the border too the root lies beyond.
        float reach = 0.5f * side + 4.0f * slack;
        bool beyond = max(off.x, off.y) > reach;
        if (beyond && at_border && alone) {
            root.decided = true;
            return root;
        }
        at_border = beyond;
        b = clamp(target, middle - vec2(reach), middle + vec2(reach));
    }
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

FUNC void take_root(Primitive p, PatchFrame f, vec2 b, float z, float t_min, vec3 margin, INOUT(bool) found,
                    INOUT(SurfaceHit) hit) {
    if (!in_triangle(b, margin) || z < t_min || z > hit.t || !opaque_at(p, b)) return;
    note(kNoteRoot, z, patch_texel(f, b), 0.0f, 0.0f);
    hit.t = z;
    hit.b = b;
    found = true;
}

FUNC bool search_patches(Primitive p, PrimitiveNormals n, ObjectData ob, vec3 o, vec3 d, float t_min, float t_max,
                         float rounding, vec3 margin, OUT(SurfaceHit) hit) {
    PatchFrame f = make_patch_frame(p, n, o, d);
    float turn = max(length(f.n1 + f.n2), length(f.n1 - f.n2));
    float texels = max(abs(f.tx1.x) + abs(f.tx2.x), abs(f.tx1.y) + abs(f.tx2.y));
    float least = kLeastPatch * max(abs(p.w_low), abs(p.w_high)) + 2.0f * rounding;
    bool found = false;
    uint code = 0u;
    int depth = 0;
    hit.t = t_max;
    hit.b = vec2(0.0f, 0.0f);
    for (int i = 0; i < kMaxPatches; ++i) {
        float side = power_of_two(-depth);
        vec2 corner = vec2(float(even_bits(code)), float(even_bits(code >> 1u))) * side;
        bool down = false;
        if (corner.x + corner.y < 1.0f) {
            vec2 low, high;
            patch_texels(f, corner, side, low, high);
            vec2 range = patch_displacement(p, ob, low, high);
            PatchBox box = patch_box(f, corner, side, range);
            note(kNoteStep, 0.0f, patch_texel(f, corner), range.y, side * texels);
            if (box_met(box, rounding, t_min, hit.t)) {
                vec3 size = box.high - box.low;
                bool last = depth == kPatchDepth || max(max(size.x, size.y), size.z) <= least;
                down = !last;
                if (last || (side * texels <= kPatchTexels && side * turn <= kPatchTurn)) {
                    vec2 first = floor(low), count = min(floor(high) - first, vec2(1.0f));
                    bool decided = true;
                    for (int k = 0; k < 4; ++k) {
                        vec2 step = vec2(float(k & 1), float(k >> 1));
                        if (step.x > count.x || step.y > count.y) continue;
                        PatchRoot root = solve_patch(p, ob, f, corner, side, first + step, rounding);
                        note(kNoteCell, root.z, patch_texel(f, root.b), 0.0f, root.z);
                        decided = decided && root.decided;
                        if (root.inside) take_root(p, f, root.b, root.z, t_min, margin, found, hit);
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
