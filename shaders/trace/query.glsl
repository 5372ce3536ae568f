// Tracing by ray query: the loop over the boxes that the ray meets, each answered by the method.
#extension GL_EXT_ray_query : require
#include "bindings.glsl"
#include "compute.glsl"

layout(set = 0, binding = kBindTlas) uniform accelerationStructureEXT scene_bvh;

TraceHit trace_ray(vec3 origin, vec3 direction, float t_min, float t_max, bool any_hit, uint pixel) {
    TraceHit best;
    best.primitive = kNoHit;
    best.t = t_max;
    best.b = vec2(0.0);
    if (t_max < t_min) return best;
    rayQueryEXT query;
    rayQueryInitializeEXT(query, scene_bvh, any_hit ? gl_RayFlagsTerminateOnFirstHitEXT : gl_RayFlagsNoneEXT, 0xff,
                          origin, t_min, direction, t_max);
    while (rayQueryProceedEXT(query)) {
        uint box = uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, false));
        if (!test_box(box, origin, direction, t_min, pixel, best)) continue;
        rayQueryGenerateIntersectionEXT(query, best.t);
        if (any_hit) break;
    }
    flush_counts(pixel);
    return best;
}
