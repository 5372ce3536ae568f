// Pre-tessellation: micro-triangles of S, made on the processor (renderer/micro_mesh.h). The baseline that displacement
// methods without tessellation (paper 002, thesis 000) are measured against. Ray queries and the pipeline meet them as
// triangles of the driver's acceleration structure, by its own test, which GPUs made for rays have in hardware; our own tree
// holds a box around each, and the test is the one below.
//
// That test is watertight (Woop, Benthin and Wald 2013, without its fallback to double: an edge value of exactly 0 counts for
// both sides). It also says where on the driver's triangle a ray meets it, so that all ways of tracing tell the same distance
// and place of a triangle to the bit. Which triangle it is they may decide differently only where a ray meets several within
// rounding, on an edge or where sheets touch: the rule that the least primitive wins among equals is not the driver's. And
// where the driver meets a triangle that the test passes beside, over an edge within rounding, the driver's word stands:
// nothing opens between neighbours. A driver does not meet what lies exactly at a ray's ends, our own tree does.
//
// The hit's barycentrics are interpolated from those of the corners; the layers' normals are those of S there, not of the
// flat micro-triangle.
//
// Parameters: x: density (rows of micro-triangles a texel, used by the build), y: correct_normals (0 or 1).
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer MicroVertices { MicroVertex at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer MicroCorners { uvec3 at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer MicroPrimitives { uint at[]; };

#define RELIEVO_OWN_BOXES
uint primitive_of_box(uint box) { return MicroPrimitives(frame.micro_primitives).at[box]; }

struct MicroTriangle {
    MicroVertex a, b, c;
};

MicroTriangle micro_triangle(uint i) {
    uvec3 corners = MicroCorners(frame.micro_corners).at[i];
    MicroVertices vertices = MicroVertices(frame.micro_vertices);
    return MicroTriangle(vertices.at[corners.x], vertices.at[corners.y], vertices.at[corners.z]);
}

// The axes permuted so that the ray's longest component is the last.
vec3 turned(vec3 v, int last) { return last == 0 ? v.yzx : last == 1 ? v.zxy : v; }

// Where the line of the ray meets the triangle. False: beside it, or along its plane.
bool meets(MicroTriangle m, vec3 o, vec3 d, out SurfaceHit hit) {
    vec3 size = abs(d);
    int last = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    vec3 k = turned(d, last), a = turned(m.a.position - o, last), b = turned(m.b.position - o, last),
         c = turned(m.c.position - o, last);
    vec2 shear = k.xy / k.z;
    // Sheared so that the ray is the last axis. The same arithmetic for a corner in all its triangles.
    precise vec2 a2 = a.xy - shear * a.z, b2 = b.xy - shear * b.z, c2 = c.xy - shear * c.z;
    precise float u0 = c2.x * b2.y, u1 = c2.y * b2.x, v0 = a2.x * c2.y, v1 = a2.y * c2.x, w0 = b2.x * a2.y, w1 = b2.y * a2.x;
    precise float u = u0 - u1, v = v0 - v1, w = w0 - w1;
    float det = u + v + w;
    if ((min(min(u, v), w) < 0.0 && max(max(u, v), w) > 0.0) || det == 0.0) return false;
    float inverse = 1.0 / det;
    hit.t = (u * a.z + v * b.z + w * c.z) * inverse / k.z;
    hit.b = (m.a.b * u + m.b.b * v + m.c.b * w) * inverse;
    return true;
}

bool intersect_surface(Primitive p, ObjectData ob, vec4 parameters, vec3 o, vec3 d, float t_min, float t_max, float random,
                       out SurfaceHit hit) {
    SurfaceHit met;
    hit.t = t_max;
    hit.b = vec2(0.0);
    if (!meets(micro_triangle(asked_box), o, d, met)) return false;
    note(kNoteStep, met.t, texel_at(p, met.b), 0.0, 0.0);
    if (!(met.t >= t_min && met.t <= t_max) || !opaque_at(p, met.b)) return false;
    note(kNoteRoot, met.t, texel_at(p, met.b), 0.0, 0.0);
    hit = met;
    return true;
}

#define RELIEVO_TRIANGLES
SurfaceHit triangle_hit(uint triangle, vec3 o, vec3 d, float t_min, float t, vec2 corners) {
    MicroTriangle m = micro_triangle(triangle);
    SurfaceHit hit;
    if (meets(m, o, d, hit) && hit.t >= t_min && !isinf(hit.t)) return hit;
    return SurfaceHit(t, m.a.b * (1.0 - corners.x - corners.y) + m.b.b * corners.x + m.c.b * corners.y);
}

vec3 shading_normal(Primitive p, PrimitiveNormals n, ObjectData ob, vec4 parameters, vec2 b) {
    return displaced_normal(p, n, ob, b, parameters.y > 0.5);
}
