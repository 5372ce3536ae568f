// Displacement BVH (thesis 000, section 4.2, after tessellation-free displacement mapping, Thonat and others 2021).
//
// The texture's squares over the triangle are the nodes of a tree that is never stored: a node's box is made on the fly from
// its height bounds (box.glsl), its children are its quarters, its parent is found by shifting its place: down, next and up
// need no stack. Up to four neighbouring squares as large as the footprint are the roots. Squares beyond the triangle's
// edges are dropped before a box is made. Where the target level of detail is reached, the box itself is the hit, or a
// local surface (leaf.glsl) is met.
//
// Deviations from the thesis, beside those of box.glsl, part_prism.glsl and leaf.glsl:
//  - squares lie between texel centres, where S's heights are bilinear, in place of texels;
//  - the four roots are the children of one square that is not tested, so that one walk visits them all;
//  - children are visited in the order of the ray: their places are mirrored so that the nearest is the first;
//  - any map size and wrap: bounds come from nodes that overlap (map_bounds), so that squares need not fit the map's own;
//  - where Newton cannot tell whether a leaf is met once, the walk goes on below it, down to kSubLevels further;
//  - without a level of detail of its own, a square that looks smaller than a pixel is met as its box (by_pixel);
//  - a ray that has been held against kFineBoxes boxes of a triangle in vain ends at the next one that it meets, of a leaf's
//    size first, then of ever larger ones: it must not pass for want of boxes. A box that holds its origin is divided.
// The holes that the thesis shows at high quality had two causes: boxes without a margin, which rays pass between by
// rounding, and leaves that differ between neighbours along base edges (leaf.glsl).
//
// Parameters: x: leaf (kLeaf*), y: level of detail (a leaf is 2^y texels wide, leaf_level_of), z: by_pixel, w: correct_normals.
#include "box.glsl"
#include "leaf.glsl"

const int kMaxBoxes = 131072;      // a triangle: beyond, the best of what was found counts;
const int kFineBoxes = 122880;     // if nothing was by then, boxes are the surface: leaves' own first,
const int kCoarserBoxes = 256;     // and after each so many more, those of twice the width
const int kWideTree = 12;          // levels above the leaves: a lower tree runs out of boxes by folds alone, not by its width
const int kMostDepth = 28;        // of the tree
const int kSubLevels = 8;         // below the leaf
const float kLeafTurn = 0.15f;    // radians that normals may turn over a leaf that is solved
const float kLeastBox = 1e-4f;    // size of a box that is not divided below the leaf, of the greatest displacement

// Least and greatest map value over a square of 2^level texels, level > leaf level, or the leaf's by map_bounds for B-splines.
// `texel`: its lowest, of a cell of the leaf's where the domain is thin.
FUNC vec2 square_values(Primitive p, ObjectData ob, bool thin, float leaf, int leaf_level, vec2 texel, int level) {
    vec2 cell = primitive_base(p) + texel;
    int taken = max(level, 1);
    if (thin) {
        // It reaches into one cell of the leaf's more, and control points lie up to two further out.
        cell = cell - vec2(leaf_level > 0 || leaf == kLeafBspline ? power_of_two(leaf_level) : 0.0f);
        if (leaf_level > 0 || leaf == kLeafBspline) taken = level + 2;
    } else if (leaf == kLeafBspline) {
        // Control points lie up to a leaf further out.
        taken = level > leaf_level ? level + 1 : level + 2;
        cell = cell - vec2(power_of_two(leaf_level));
    } else if (level > 1 && !is_procedural(p.object)) {
        // A square that lies on nodes half as large is two by two of them exactly (procedural bounds know no nodes).
        int half_mask = (1 << (level - 1)) - 1;
        if (ob.clamp_wrap != 0u || ((ob.map_size.x | ob.map_size.y) & half_mask) == 0) taken = level - 1;
    }
    return taken <= kPyramidLevels ? map_bounds(p.object, taken, cell) : vec2(0.0f, 1.0f);
}

// As displacements. S itself lies within the triangle's own range; leaves that reach over its texels need not.
FUNC vec2 displacement_range(Primitive p, ObjectData ob, vec2 values, bool of_surface) {
    float d0 = displacement(ob, values.x), d1 = displacement(ob, values.y);
    vec2 d = vec2(min(d0, d1), max(d0, d1));
    if (!of_surface) return d;
    d = vec2(max(d.x, p.w_low), min(d.y, p.w_high));
    return d.x <= d.y ? d : vec2(p.w_low, p.w_high);
}

FUNC float greatest_displacement(ObjectData ob) { return abs(ob.amplitude) * max(ob.midlevel, 1.0f - ob.midlevel); }

// log2 of a leaf's texels. Where the map repeats its leaves must, too, or neighbours on both sides of a period would not
// agree: they are at most as wide as divides both its sides.
FUNC int leaf_level_of(Primitive p, ObjectData ob, float asked) {
    int level = int(asked);
    if (ob.clamp_wrap != 0u || is_procedural(p.object)) return level;
    return min(level, findLSB(ob.map_size.x | ob.map_size.y));
}

struct Walk {        // where the walk through a triangle's squares is
    ivec2 at;        // among the squares of its level, mirrored into the ray's order
    int level;       // log2 of the square's texels
    int top;         // of the square over the four roots
    vec2 corner;     // of that square, texels relative to the primitive's base
    ivec2 mirror;    // -1 where the order along an axis is turned round
};

// `base`: the whole place that the domain's coordinates are relative to.
FUNC Walk start_walk(vec2 base, Domain g, vec3 d, int leaf_level) {
    Walk w;
    vec2 extent = g.high - g.low, first = base + floor(g.t0 + g.low);  // whole: exact
    int root = max(int(ceil(log2(max(max(extent.x, extent.y), 1.0f)))), leaf_level);
    float size = power_of_two(root);
    w.at = ivec2(0, 0);
    w.level = root + 1;
    w.top = root + 1;
    w.corner = floor(first / size) * size - base;
    w.mirror = ivec2(dot(g.px, d) < 0.0f ? -1 : 0, dot(g.py, d) < 0.0f ? -1 : 0);
    return w;
}

FUNC vec2 square_of(Walk w) {
    int last = (1 << (w.top - w.level)) - 1;
    return w.corner + vec2((w.at ^ w.mirror) & last) * power_of_two(w.level);
}

// Of the leaf that holds the square.
FUNC vec2 leaf_square(Walk w, int leaf_level) {
    w.at = w.at >> (leaf_level - w.level);
    w.level = leaf_level;
    return square_of(w);
}

FUNC void go_down(INOUT(Walk) w) {
    w.at = w.at << 1;
    --w.level;
}

// The next square, after as many steps up as it takes. False at the end.
FUNC bool go_next(INOUT(Walk) w) {
    int up = findLSB(~(w.at.x & w.at.y));  // the last of their parents' four
    w.at = w.at >> up;
    w.level += up;
    if (w.level >= w.top) return false;
    if ((w.at.x & 1) == 0) {
        w.at.x = w.at.x | 1;
    } else {
        w.at.x = w.at.x ^ 1;
        w.at.y = w.at.y | 1;
    }
    return true;
}

// Where the ray enters the box, and leaves it.
FUNC vec2 box_span(DisplacedBox box, vec3 o, vec3 inverse) {
    vec3 a = (box.low - o) * inverse, b = (box.high - o) * inverse, near = min(a, b), far = max(a, b);
    return vec2(max(max(near.x, near.y), near.z), min(min(far.x, far.y), far.z));
}

// Squares up to this wide are met as their boxes, after `boxes` of the walk; a leaf is `leaf_size` wide.
FUNC float met_whole(int boxes, float leaf_size) {
    return boxes < kFineBoxes ? 0.0f : leaf_size * power_of_two((boxes - kFineBoxes) / kCoarserBoxes);
}

struct DbvhRay {
    vec3 o, d, inverse;  // in the triangle's frame, from t0 on
    float t0, t_min, rounding;
    vec3 margin;         // barycentric, of the edges
};

FUNC void take_hit(Primitive p, vec2 b, float t, INOUT(bool) found, INOUT(SurfaceHit) hit) {
    if (t > hit.t || !opaque_at(p, b)) return;
    note(kNoteRoot, t, texel_at(p, b), 0.0f, 0.0f);
    hit.t = t;
    hit.b = b;
    found = true;
}

// Meets a box; a ray that starts in it leaves it.
FUNC void take_box(Primitive p, Domain g, vec2 middle, DbvhRay r, float entry, INOUT(bool) found, INOUT(SurfaceHit) hit) {
    vec2 b = max(barycentrics_at(g, middle), vec2(0.0f));
    if (r.t0 + entry >= r.t_min) take_hit(p, b / max(b.x + b.y, 1.0f), r.t0 + entry, found, hit);
}

FUNC float edge_slack(DbvhRay r) { return 2.0f * max(r.margin.x, max(r.margin.y, r.margin.z)); }

// World units: what the normal's turning adds to S over a leaf, to second order. A triangle's plane goes on beyond it by as
// much as its heights differ.
FUNC float leaf_bend(float turn, vec2 heights, bool plane) {
    float differ = (heights.y - heights.x) * (plane ? 2.0f : 1.0f);
    return 0.5f * turn * (differ + 0.5f * turn * max(abs(heights.x), abs(heights.y)));
}

#include "part_prism.glsl"
#ifndef __cplusplus  // needs a source
#include "lattice.glsl"
#endif

// Meets the leaf's pieces over the rectangle. False where there may be a hit that was not found.
FUNC bool meet_leaf(Primitive p, ObjectData ob, Domain g, DbvhRay r, LeafCells cells, float leaf, float stride, vec2 middle,
                    vec2 half_size, float turn, vec2 heights, bool last, INOUT(bool) found, INOUT(SurfaceHit) hit) {
    bool decided = true, more = true;
    while (more) {
        vec2 square = cells.cell, f0 = (cells.low - square) / stride, f1 = (cells.high - square) / stride;
        int i = cells.piece;
        more = next_piece(leaf, stride, cells);
        if (leaf == kLeafTriangles && (i == 0 ? f0.x + f0.y > 1.001f : f1.x + f1.y < 0.999f)) continue;
        vec2 of_middle = middle, of_half = half_size;
        if (leaf == kLeafBspline && !g.thin) {
            vec2 corner = vec2(float(i & 1), float(i >> 1)) * 0.5f, low = max(f0, corner), high = min(f1, corner + vec2(0.5f));
            if (low.x > high.x || low.y > high.y) continue;
            of_middle = square - g.t0 + 0.5f * stride * (low + high);
            of_half = 0.5f * stride * (high - low);
        }
        Piece e = make_piece(p, leaf, square, stride, i);
        // Over a rectangle that lies over several cells, a cell's own slope goes on beyond it, further than the heights there.
        vec2 reached = heights;
        if (g.thin) reached = displacement_range(p, ob, piece_bounds(e, f0, f1), false);
        float bend = leaf_bend(turn, reached, leaf == kLeafTriangles);
        LeafRoot root = solve_piece(g, ob, e, of_middle, of_half, r.o, r.d, r.rounding, bend, last);
        float t = r.t0 + root.t;
        note(kNoteCell, t, square, 0.0f, t);
        decided = decided && root.decided;
        if (root.inside && t >= r.t_min && within_edges(root.b, r.margin)) take_hit(p, root.b, t, found, hit);
    }
    return decided;
}

FUNC bool intersect_surface(Primitive p, ObjectData ob, vec4 parameters, vec3 o, vec3 d, float t_min, float t_max,
                            float, OUT(SurfaceHit) hit) {
    float leaf = parameters.x, most = greatest_displacement(ob);
    int leaf_level = leaf_level_of(p, ob, parameters.y);
    float stride = power_of_two(leaf_level), pixel = parameters.z > 0.5f ? pixel_spread() : 0.0f;
    DbvhRay r;
    r.rounding = rounding_of_ray(p, o);
    r.margin = edge_margins(p, r.rounding);
    r.t_min = t_min;
    r.t0 = dot(p.origin - o, d);
    r.o = in_frame(p, o + d * r.t0 - p.origin);
    r.d = in_frame(p, d);
    r.inverse = vec3(1.0f) / vec3(abs(r.d.x) < 1e-20f ? 1e-20f : r.d.x, abs(r.d.y) < 1e-20f ? 1e-20f : r.d.y,
                                  abs(r.d.z) < 1e-20f ? 1e-20f : r.d.z);
    hit.t = t_max;
    hit.b = vec2(0.0f, 0.0f);
#ifndef __cplusplus
    int log_range = log_range_of(fifth_parameter());
    if (log_range > 0 && is_procedural(p.object)) {
        ProceduralData data = procedural_data(p.object);
        LatticeMap m = lattice_map(data, signed_whole(primitive_base(p)));
        if (lattice_serves(data, m, power_of_two(log_range))) return intersect_lattice(p, ob, data, m, leaf, log_range, pixel, r, hit);
    }
#endif
    Domain g = make_domain(p, primitive_normals(), is_thin(p), most, r.rounding);
    Walk w = start_walk(g.thin ? vec2(0.0f) : primitive_base(p), g, r.d, leaf_level);
    int lowest = max(leaf_level - kSubLevels, w.top - kMostDepth);
    float least = kLeastBox * most + 2.0f * g.margin;
    bool found = false, down = true, wide = w.top - leaf_level > kWideTree;
    for (int i = 0; i < kMaxBoxes; ++i) {
        if (down) go_down(w);
        else if (!go_next(w)) break;
        down = false;
        vec2 square = square_of(w);
        float size = power_of_two(w.level);
        vec2 low = max(square - g.t0, g.low), high = min(square - g.t0 + vec2(size), g.high);
        if (!(low.x <= high.x && low.y <= high.y)) continue;
        vec2 middle = 0.5f * (low + high), half_size = 0.5f * (high - low);
        if (outside_triangle(g, middle, half_size, edge_slack(r))) continue;
        vec2 of_leaf = w.level < leaf_level ? leaf_square(w, leaf_level) : square;
        bool by_pieces = w.level < leaf_level || (w.level == leaf_level && leaf != kLeafBspline);
        LeafCells cells = leaf_cells(p, g, of_leaf, stride, middle, half_size);
        vec2 texel = g.thin ? cells.first : square;
        vec2 values = by_pieces ? leaf_values(p, cells, leaf, stride)
                                : square_values(p, ob, g.thin, leaf, leaf_level, texel, w.level);
        vec2 heights = displacement_range(p, ob, values, leaf == kLeafBilinear && leaf_level == 0);
        DisplacedBox box = displaced_box(g, middle, half_size, heights);
        vec2 span = box_span(box, r.o, r.inverse);
        note(kNoteStep, r.t0 + span.x, texel, 0.0f, size);
        if (!(span.x <= span.y && r.t0 + span.y >= t_min && r.t0 + span.x <= hit.t)) continue;
        vec3 extent = box.high - box.low;
        float largest = max(max(extent.x, extent.y), extent.z);
        // Below a pixel, by choice, or for want of boxes, the box is the surface.
        bool whole = wide && !found && size <= met_whole(i, stride) && r.t0 + span.x >= t_min;
        if ((w.level <= leaf_level && leaf == kLeafBox) || largest <= pixel * (r.t0 + span.x) || whole) {
            take_box(p, g, middle, r, span.x, found, hit);
            continue;
        }
        if (w.level > leaf_level) {
            down = true;
            continue;
        }
        bool last = w.level <= lowest || largest <= least;
        down = !last;
        if (last || box.turn <= kLeafTurn) {
            down = !meet_leaf(p, ob, g, r, cells, leaf, stride, middle, half_size, box.turn, heights, last, found, hit) && !last;
        }
    }
    return found;
}

// Triangles shade flat, B-splines by their own slope, bilinear leaves as S. So do boxes, and the parts of a procedural
// source's lattice: which face of a box, or which part, was met is not kept.
FUNC vec3 shading_normal(Primitive p, PrimitiveNormals n, ObjectData ob, vec4 parameters, vec2 b) {
    float leaf = parameters.x;
    bool of_leaf = leaf == kLeafTriangles || leaf == kLeafBspline;
#ifndef __cplusplus
    of_leaf = of_leaf && !(is_procedural(p.object) && log_range_of(fifth_parameter()) > 0);
#endif
    bool correct = parameters.w > 0.5f;
    if (!of_leaf) return displaced_normal(p, n, ob, b, correct);
    float stride = power_of_two(leaf_level_of(p, ob, parameters.y));
    return normal_of_gradient(p, n, ob, b, leaf_gradient(p, leaf, stride, texel_at(p, b)), correct);
}
