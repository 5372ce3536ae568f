// Tracing by ray query: the loop over the boxes that the ray meets, each answered by the method.
#extension GL_EXT_ray_query : require
#include "bindings.glsl"

TraceHit trace_ray(vec3 origin, vec3 direction, float t_min, float t_max, bool any_hit, uint pixel) {
    TraceHit best;
    best.primitive = kNoHit;
    best.t = t_max;
    best.b = vec2(0.0);
    rayQueryEXT query;
    rayQueryInitializeEXT(query, scene_bvh, any_hit ? gl_RayFlagsTerminateOnFirstHitEXT : gl_RayFlagsNoneEXT, 0xff,
                          origin, t_min, direction, t_max);
    while (rayQueryProceedEXT(query)) {
        uint id = uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, false));
        Primitive p = primitives[id];
        SurfaceHit hit;
        begin_notes(id);
        float random = random_at(pixel, push.sample_index, id);
        if (intersect_surface(p, object_data(p.object), frame.parameters0, origin, direction, t_min, best.t, random,
                              hit)) {
            note_hit(p, hit);
            best.primitive = id;
            best.t = hit.t;
            best.b = hit.b;
            rayQueryGenerateIntersectionEXT(query, hit.t);
            if (any_hit) break;
        }
    }
    flush_counts(pixel);
    return best;
}

layout(local_size_x = 64) in;

// An 8 x 8 workgroup whose subgroups of 8 lanes cover 4 x 2 pixels: their rays stay together.
ivec2 invocation_pixel() {
    uint i = gl_LocalInvocationIndex;
    uvec2 within = uvec2((i & 3u) | ((i >> 1u) & 4u), ((i >> 2u) & 1u) | ((i >> 3u) & 6u));
    return ivec2(gl_WorkGroupID.xy * kGroupWidth + within);
}
int invocation_index() { return int(gl_GlobalInvocationID.x); }
