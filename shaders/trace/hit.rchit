#version 460
#extension GL_GOOGLE_include_directive : require
// Closest hit of the pipeline path: hands the hit back, all shading is in the caller.
#extension GL_EXT_ray_tracing : require
#include "bindings.glsl"

layout(location = 0) rayPayloadInEXT TraceHit payload;

#ifdef RELIEVO_TRIANGLES
#include "triangles.glsl"

hitAttributeEXT vec2 corners;

void main() {
    payload = nearest_triangle(uint(gl_PrimitiveID), gl_WorldRayOriginEXT, gl_WorldRayDirectionEXT, gl_RayTminEXT, gl_HitTEXT,
                               corners);
}
#else
hitAttributeEXT vec2 attribute_b;

void main() {
    payload.primitive = primitive_of_box(uint(gl_PrimitiveID));
    payload.t = gl_HitTEXT;
    payload.b = attribute_b;
}
#endif
