// The canonical surface of DESIGN.md section 1, S(b) = P(b) + D(b) N(b)/|N(b)|: its point and its normals.
#ifndef RELIEVO_SURFACE_GLSL
#define RELIEVO_SURFACE_GLSL

FUNC vec3 frame_bitangent(Primitive p) { return cross(p.ng, p.tangent); }

FUNC vec3 base_edge1(Primitive p) { return p.tangent * p.q1x; }
FUNC vec3 base_edge2(Primitive p) { return p.tangent * p.q2.x + frame_bitangent(p) * p.q2.y; }

FUNC vec3 base_normal(PrimitiveNormals n, vec2 b) {
    return n.n0 * (1.0f - b.x - b.y) + n.n1 * b.x + n.n2 * b.y;
}

// World units, of a map value.
FUNC float displacement(ObjectData ob, float value) { return ob.amplitude * (value - ob.midlevel); }

FUNC float displacement_at(Primitive p, ObjectData ob, vec2 b) {
    return displacement(ob, map_value(p.object, primitive_base(p), texel_at(p, b)));
}

FUNC vec3 surface_point(Primitive p, PrimitiveNormals n, ObjectData ob, vec2 b) {
    return p.origin + base_edge1(p) * b.x + base_edge2(p) * b.y +
           normalize(base_normal(n, b)) * displacement_at(p, ob, b);
}

// From the base triangle to the curved surface that its vertex normals tell of, where that stands over it: the place's
// distances below the vertices' tangent planes, blended (Hanika, Hacking the Shadow Terminator, Ray Tracing Gems II, 2021).
FUNC vec3 bulge_over(Primitive p, PrimitiveNormals n, vec2 b) {
    vec3 from0 = base_edge1(p) * b.x + base_edge2(p) * b.y, from1 = from0 - base_edge1(p), from2 = from0 - base_edge2(p);
    return n.n0 * (max(-dot(from0, n.n0), 0.0f) * (1.0f - b.x - b.y)) + n.n1 * (max(-dot(from1, n.n1), 0.0f) * b.x) +
           n.n2 * (max(-dot(from2, n.n2), 0.0f) * b.y);
}

// Unit normal of S on the side of the base triangle's normal, from the derivatives of S with the given gradient of
// the map (per texel). Falls back to the base normal where S has no tangent plane.
FUNC vec3 surface_normal(Primitive p, PrimitiveNormals n, ObjectData ob, vec2 b, vec2 gradient) {
    vec3 big_n = base_normal(n, b);
    float inverse = 1.0f / max(length(big_n), 1e-20f);
    vec3 unit_n = big_n * inverse;
    float d = displacement_at(p, ob, b);
    vec3 n1 = n.n1 - n.n0, n2 = n.n2 - n.n0;
    vec2 t1 = p.tx1 - p.tx0, t2 = p.tx2 - p.tx0;
    vec3 s1 = base_edge1(p) + (n1 - unit_n * dot(unit_n, n1)) * (inverse * d) +
              unit_n * (ob.amplitude * dot(gradient, t1));
    vec3 s2 = base_edge2(p) + (n2 - unit_n * dot(unit_n, n2)) * (inverse * d) +
              unit_n * (ob.amplitude * dot(gradient, t2));
    vec3 c = cross(s1, s2);
    float l = length(c);
    return l > 0.0f ? c * (1.0f / l) : p.ng;
}

FUNC vec3 geometric_normal(Primitive p, PrimitiveNormals n, ObjectData ob, vec2 b) {
    return surface_normal(p, n, ob, b, cell_gradient(p.object, primitive_base(p), texel_at(p, b)));
}

// Shading normal as paper 002's Algorithm 1 makes it: differentials of P + D N' with N' held, for a gradient of the map
// per texel, and the correction of its section 5.1, N' in Ng's stead, as a switch.
FUNC vec3 normal_of_gradient(Primitive p, PrimitiveNormals n, ObjectData ob, vec2 b, vec2 gradient, bool correct) {
    vec3 smooth_n = normalize(base_normal(n, b));
    vec2 g = gradient * ob.amplitude;
    vec3 s1 = base_edge1(p) + smooth_n * dot(g, p.tx1 - p.tx0);
    vec3 s2 = base_edge2(p) + smooth_n * dot(g, p.tx2 - p.tx0);
    vec3 displaced = normalize(cross(s1, s2));
    return correct ? normalize(displaced - p.ng + smooth_n) : displaced;
}

// The same over half a texel to either side.
FUNC vec3 displaced_normal(Primitive p, PrimitiveNormals n, ObjectData ob, vec2 b, bool correct) {
    return normal_of_gradient(p, n, ob, b, smooth_gradient(p.object, primitive_base(p), texel_at(p, b)), correct);
}

#endif
