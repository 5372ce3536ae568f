// What the two ways of tracing in compute shaders share: a primitive's test, and how invocations lie over pixels.
#include "wide_loads.glsl"

layout(local_size_x = 64) in;

// An 8 x 8 workgroup whose subgroups of 8 lanes cover 4 x 2 pixels: their rays stay together.
ivec2 invocation_pixel() {
    uint i = gl_LocalInvocationIndex;
    uvec2 within = uvec2((i & 3u) | ((i >> 1u) & 4u), ((i >> 2u) & 1u) | ((i >> 3u) & 6u));
    return ivec2(gl_WorkGroupID.xy * kGroupWidth + within);
}
int invocation_index() { return int(gl_GlobalInvocationID.x); }

// Meets the primitive, through a box that the ray meets. Of equally near hits the least index wins, in whatever order boxes
// come; and a method's answer does not depend on best.t, but for being beyond it.
bool test_primitive(Primitive p, uint id, uint box, vec3 origin, vec3 direction, float t_min, uint pixel,
                    inout TraceHit best) {
    SurfaceHit hit;
    begin_notes(id, box);
    float random = random_at(pixel, push.sample_index, id);
    if (!intersect_surface(p, object_data(p.object), frame.parameters0, origin, direction, t_min, best.t, random, hit))
        return false;
    if (hit.t == best.t && id > best.primitive) return false;
    note_hit(p, hit);
    best.primitive = id;
    best.t = hit.t;
    best.b = hit.b;
    return true;
}

bool test_box(uint box, vec3 origin, vec3 direction, float t_min, uint pixel, inout TraceHit best) {
    uint id = primitive_of_box(box);
    return test_primitive(load_primitive(id), id, box, origin, direction, t_min, pixel, best);
}
