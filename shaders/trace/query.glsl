// Tracing by ray query: the loop over the boxes that the ray meets, each answered by the method; or, where the method meets
// the driver's triangles, over those that the driver asks about.
#extension GL_EXT_ray_query : require
#include "bindings.glsl"
#include "compute.glsl"
#ifdef RELIEVO_TRIANGLES
#include "triangles.glsl"
#else
const uint kTriangleFlags = gl_RayFlagsNoneEXT;
#endif

layout(set = 0, binding = kBindTlas) uniform accelerationStructureEXT scene_bvh;

TraceHit trace_ray(vec3 origin, vec3 direction, float t_min, float t_max, bool any_hit, uint pixel) {
    TraceHit best;
    best.primitive = kNoHit;
    best.t = t_max;
    best.b = vec2(0.0);
    if (t_max < t_min) return best;
    rayQueryEXT query;
    uint flags = kTriangleFlags | (any_hit ? gl_RayFlagsTerminateOnFirstHitEXT : gl_RayFlagsNoneEXT);
    rayQueryInitializeEXT(query, scene_bvh, flags, 0xff, origin, t_min, direction, t_max);
    while (rayQueryProceedEXT(query)) {
        uint met = uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, false));
#ifdef RELIEVO_TRIANGLES
        if (accept_triangle(met, origin, direction, t_min, rayQueryGetIntersectionTEXT(query, false),
                            rayQueryGetIntersectionBarycentricsEXT(query, false)))
            rayQueryConfirmIntersectionEXT(query);
#else
        if (!test_box(met, origin, direction, t_min, pixel, best)) continue;
        rayQueryGenerateIntersectionEXT(query, best.t);
        if (any_hit) break;
#endif
    }
#ifdef RELIEVO_TRIANGLES
    if (rayQueryGetIntersectionTypeEXT(query, true) == gl_RayQueryCommittedIntersectionTriangleEXT) {
        if (any_hit) best.primitive = 0u;  // whichever it was
        else best = nearest_triangle(uint(rayQueryGetIntersectionPrimitiveIndexEXT(query, true)), origin, direction, t_min,
                                     rayQueryGetIntersectionTEXT(query, true),
                                     rayQueryGetIntersectionBarycentricsEXT(query, true));
    }
#endif
    flush_counts(pixel);
    return best;
}
