// Tracing by the ray tracing pipeline: for devices without ray query. The intersection shader (hit.rint) calls the
// same method, or the driver meets its triangles by itself; the payload brings back what the ray query keeps in variables.
#extension GL_EXT_ray_tracing : require
#include "bindings.glsl"
#ifdef RELIEVO_TRIANGLES
#include "triangles.glsl"
#else
const uint kTriangleFlags = gl_RayFlagsNoneEXT;
#endif

layout(set = 0, binding = kBindTlas) uniform accelerationStructureEXT scene_bvh;

layout(location = 0) rayPayloadEXT TraceHit payload;

TraceHit trace_ray(vec3 origin, vec3 direction, float t_min, float t_max, bool any_hit, uint pixel) {
    if (t_max < t_min) return TraceHit(kNoHit, t_max, vec2(0.0));
    payload.primitive = 0u;  // any hit: no closest-hit shader runs, the miss shader alone speaks
    payload.t = t_max;
    payload.b = vec2(0.0);
    uint flags = any_hit ? gl_RayFlagsTerminateOnFirstHitEXT | gl_RayFlagsSkipClosestHitShaderEXT : gl_RayFlagsNoneEXT;
    traceRayEXT(scene_bvh, kTriangleFlags | flags, 0xff, 0, 0, 0, origin, t_min, direction, t_max, 0);
    return payload;
}

ivec2 invocation_pixel() { return ivec2(gl_LaunchIDEXT.xy); }
int invocation_index() { return int(gl_LaunchIDEXT.x); }
