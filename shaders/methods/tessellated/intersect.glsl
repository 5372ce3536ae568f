// Pre-tessellation: micro-triangles of S, made on the processor (renderer/micro_mesh.h), each with a box of its own in the
// tree. The baseline that displacement methods without tessellation (paper 002, thesis 000) are measured against.
//
// The test of a ray with a triangle is watertight (Woop, Benthin and Wald 2013, without its fallback to double: an edge
// value of exactly 0 counts for both sides). The hit's barycentrics are interpolated from those of the corners; the layers'
// normals are those of S there, not of the flat micro-triangle.
//
// Parameters: x: density (rows of micro-triangles a texel, used by the build), y: correct_normals (0 or 1).
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer MicroVertices { MicroVertex at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer MicroTriangles { MicroTriangle at[]; };

#define RELIEVO_OWN_BOXES
uint primitive_of_box(uint box) { return MicroTriangles(frame.micro_triangles).at[box].primitive; }

// The axes permuted so that the ray's longest component is the last.
vec3 turned(vec3 v, int last) { return last == 0 ? v.yzx : last == 1 ? v.zxy : v; }

bool intersect_surface(Primitive p, ObjectData ob, vec4 parameters, vec3 o, vec3 d, float t_min, float t_max, float random,
                       out SurfaceHit hit) {
    hit.t = t_max;
    hit.b = vec2(0.0);
    MicroTriangle m = MicroTriangles(frame.micro_triangles).at[asked_box];
    MicroVertices vertices = MicroVertices(frame.micro_vertices);
    MicroVertex va = vertices.at[m.vertex.x], vb = vertices.at[m.vertex.y], vc = vertices.at[m.vertex.z];
    vec3 size = abs(d);
    int last = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    vec3 k = turned(d, last), a = turned(va.position - o, last), b = turned(vb.position - o, last),
         c = turned(vc.position - o, last);
    vec2 shear = k.xy / k.z;
    // Sheared so that the ray is the last axis. The same arithmetic for a corner in all its triangles.
    precise vec2 a2 = a.xy - shear * a.z, b2 = b.xy - shear * b.z, c2 = c.xy - shear * c.z;
    precise float u0 = c2.x * b2.y, u1 = c2.y * b2.x, v0 = a2.x * c2.y, v1 = a2.y * c2.x, w0 = b2.x * a2.y, w1 = b2.y * a2.x;
    precise float u = u0 - u1, v = v0 - v1, w = w0 - w1;
    float det = u + v + w;
    if ((min(min(u, v), w) < 0.0 && max(max(u, v), w) > 0.0) || det == 0.0) return false;
    float inverse = 1.0 / det, t = (u * a.z + v * b.z + w * c.z) * inverse / k.z;
    vec2 at = (va.b * u + vb.b * v + vc.b * w) * inverse;
    note(kNoteStep, t, texel_at(p, at), 0.0, 0.0);
    if (!(t >= t_min && t <= t_max) || !opaque_at(p, at)) return false;
    note(kNoteRoot, t, texel_at(p, at), 0.0, 0.0);
    hit.t = t;
    hit.b = at;
    return true;
}

vec3 shading_normal(Primitive p, PrimitiveNormals n, ObjectData ob, vec4 parameters, vec2 b) {
    return displaced_normal(p, n, ob, b, parameters.y > 0.5);
}
