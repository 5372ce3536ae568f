// The walk over a procedural source in its own lattice (thesis 000, sections 5.3 and 5.4): squares of lattice space down to
// one by one, then the two lattice triangles of a square, each divided as geometry/triforce.glsl has it, `range` parts a
// side. Coordinates are lattice coordinates times range, so that the finest parts lie between whole numbers.
//
// Deviations from the thesis: parts beyond the triangle's edges are dropped at every depth, and the two triangles of a square
// are bounded as such in place of the source's whole range; parts are not boxes but prisms over themselves
// (part_prism.glsl). The leaf is not its box: it is met as S with the height linear
// between the part's corners (leaf.glsl), which neighbouring parts share, so that there are no holes and normals are those
// of S. Where a part is a texel or less the leaves are S itself but for the bend within a texel.
#ifndef RELIEVO_DBVH_LATTICE_GLSL
#define RELIEVO_DBVH_LATTICE_GLSL

const int kMostLogRange = 9;
const float kLeastPart = 0.03125f;  // texels

// The greatest power of two not above the parameter `range`, as its exponent; 0 where it is below 8: squares of virtual
// texels are walked in the lattice's stead.
FUNC int log_range_of(float range) { return range < 8.0f ? 0 : min(findMSB(uint(range)), kMostLogRange); }

struct LatticeWalk {
    Walk squares;
    Triforce part;
    bool in_square;  // among the parts of its halves
    bool beyond;     // in the second half
    int order;       // part_order
    bool turned;     // the second half is the nearer one
    int log_range, range;
};

FUNC void enter_half(bool beyond, INOUT(LatticeWalk) w) {
    w.beyond = beyond;
    w.part.base = beyond ? ivec2(w.range) : ivec2(0);
    w.part.size = beyond ? -w.range : w.range;
}

FUNC void lattice_down(INOUT(LatticeWalk) w) {
    if (w.in_square) {
        w.part = triforce_down(w.part, w.order);
    } else if (w.squares.level > w.log_range) {
        go_down(w.squares);
    } else {
        w.in_square = true;
        enter_half(w.turned, w);
    }
}

FUNC bool lattice_next(INOUT(LatticeWalk) w) {
    if (w.in_square) {
        if (triforce_next(w.order, w.range, w.part)) return true;
        if (w.beyond == w.turned) {
            enter_half(!w.turned, w);
            return true;
        }
        w.in_square = false;
    }
    return go_next(w.squares);
}

// The part as a piece: linear between its corners.
FUNC Piece part_piece(Primitive p, LatticeMap m, vec2 corner, Triforce part, float range) {
    Piece e;
    float size = float(part.size);
    vec2 base = primitive_base(p);
    e.origin = corner + vec2(part.base);
    e.stride = size;
    e.low = vec2(0.0f);
    e.high = vec2(1.0f);
    e.half_plane = -1.0f;
    vec3 h = vec3(0.0f);
    for (int i = 0; i < 3; ++i) {  // a loop, so that the source's code is there once
        vec2 at = e.origin + vec2(i == 1 ? size : 0.0f, i == 2 ? size : 0.0f);
        h[i] = map_value(p.object, base, to_texels(m, at / range));
    }
    e.c0 = vec3(h.x, h.z - h.x, 0.0f);
    e.c1 = vec3(h.y - h.x, 0.0f, 0.0f);
    e.c2 = vec3(0.0f);
    return e;
}

// Over lattice space.
FUNC Primitive over_lattice(Primitive p, LatticeMap m, float range) {
    p.tx0 = to_lattice(m, p.tx0) * range;
    p.tx1 = to_lattice(m, p.tx1) * range;
    p.tx2 = to_lattice(m, p.tx2) * range;
    return p;
}

// Whether the finest parts are no smaller than kLeastPart: else the texels themselves are quicker, and true.
FUNC bool lattice_serves(ProceduralData data, LatticeMap m, float range) {
    vec2 part = vec2(1.0f) / (abs(vec2(m.across_y, m.up_x)) * range);
    return data.used == kHeightsOfLattice && min(part.x, part.y) >= kLeastPart;
}

FUNC bool intersect_lattice(Primitive p, ObjectData ob, ProceduralData data, LatticeMap m, float leaf, int log_range,
                            float pixel, DbvhRay r, INOUT(SurfaceHit) hit) {
    float range = power_of_two(log_range);
    Primitive q = over_lattice(p, m, range);
    Domain g = make_domain(q, primitive_normals(), false, greatest_displacement(ob), r.rounding);
    PrismAxes axes = prism_axes(g, r);
    vec2 lengths = vec2(length(g.px), length(g.py));  // of an edge
    LatticeWalk w;
    w.squares = start_walk(vec2(0.0f), g, r.d, log_range);
    w.in_square = false;
    w.log_range = log_range;
    w.range = 1 << log_range;
    vec2 ahead = vec2(dot(g.px, r.d), dot(g.py, r.d));
    w.order = part_order(ahead);
    w.turned = ahead.x + ahead.y < 0.0f;
    enter_half(w.turned, w);
    LatticeHalf h;
    h.square = ivec2(0);
    h.beyond = false;
    h.shift0 = h.shift1 = h.shift2 = ivec2(0);
    bool found = false, down = true;
    for (int i = 0; i < kMaxBoxes; ++i) {
        if (down) lattice_down(w);
        else if (!lattice_next(w)) break;
        down = false;
        vec2 corner = square_of(w.squares), from = corner, to = corner + vec2(power_of_two(w.squares.level));
        if (w.in_square) {
            vec2 base = corner + vec2(w.part.base), other = base + vec2(float(w.part.size));
            from = min(base, other);
            to = max(base, other);
        }
        vec2 low = max(from - g.t0, g.low), high = min(to - g.t0, g.high);
        if (!(low.x <= high.x && low.y <= high.y)) continue;
        vec2 middle = 0.5f * (low + high), half_size = 0.5f * (high - low);
        if (outside_triangle(g, middle, half_size, edge_slack(r))) continue;
        vec2 values = data.range;
        if (w.in_square) {
            // Every half is entered as a whole first.
            if (abs(w.part.size) == w.range) h = lattice_half(p.object, data, m, ivec2(corner / range), w.beyond);
            values = triforce_bounds(p.object, data, m, h, vec2(w.part.base) / range, float(w.part.size) / range);
        }
        vec2 heights = displacement_range(p, ob, values, false);
        // Where the footprint cuts a part's rectangle, its half is not known any more.
        bool cut = low.x > from.x - g.t0.x || low.y > from.y - g.t0.y || high.x < to.x - g.t0.x || high.y < to.y - g.t0.y;
        int side = cut || !w.in_square ? 0 : (w.part.size > 0 ? 1 : -1);
        PartPrism prism = part_prism(g, axes, middle, half_size, side, heights);
        vec2 span = prism_span(prism, axes);
        note(kNoteStep, r.t0 + span.x, to_texels(m, from / range), 0.0f, float(abs(w.part.size)));
        if (!(span.x <= span.y && r.t0 + span.y >= r.t_min && r.t0 + span.x <= hit.t)) continue;
        bool last = w.in_square && abs(w.part.size) == 1;
        float size = w.in_square ? float(abs(w.part.size)) : power_of_two(w.squares.level);
        bool whole = !found && size <= met_whole(i, 1.0f) && r.t0 + span.x >= r.t_min, tiny = false;
        if (pixel > 0.0f) {
            float wide = 2.0f * dot(half_size, lengths) + prism.turn * max(abs(heights.x), abs(heights.y));
            tiny = max(wide, prism.high.w - prism.low.w) <= pixel * (r.t0 + span.x);
        }
        if ((last && leaf == kLeafBox) || tiny || whole) {
            take_box(p, g, middle, r, span.x, found, hit);
        } else if (last) {
            Piece e = part_piece(p, m, corner, w.part, range);
            LeafRoot root = solve_piece(g, ob, e, middle, half_size, r.o, r.d, r.rounding, leaf_bend(prism.turn, heights, true), true);
            float t = r.t0 + root.t;
            note(kNoteCell, t, to_texels(m, e.origin / range), 0.0f, t);
            if (root.inside && t >= r.t_min && within_edges(root.b, r.margin)) take_hit(p, root.b, t, found, hit);
        } else {
            down = true;
        }
    }
    return found;
}

#endif
