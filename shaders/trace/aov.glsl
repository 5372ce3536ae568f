// The layers that are not light, at pixel centres, never jittered.
#include "camera.glsl"

layout(set = 0, binding = kBindAov, scalar) writeonly buffer AovBlock { AovPixel aov[]; };

void aov_main(ivec2 local) {
    ivec2 px;
    bool has_pixel = window_pixel(local, px);
    uint pixel = pixel_index(px);
    AovPixel a;
    a.depth = uintBitsToFloat(0x7f800000u);
    a.normal = vec3(0.0);
    a.shading_normal = vec3(0.0);
    a.uv = vec2(0.0);
    a.id = 0.0;
    TraceHit h = trace_ray(frame.eye, camera_direction(vec2(px) + 0.5), 0.0, has_pixel ? kFar : kNoReach, false, pixel);
    if (!has_pixel) return;
    if (h.primitive != kNoHit) {
        Primitive p = primitives[h.primitive];
        PrimitiveNormals n = normals[h.primitive];
        ObjectData ob = object_data(p.object);
        a.depth = h.t;
        a.normal = geometric_normal(p, n, ob, h.b);
        a.shading_normal = shading_normal(p, n, ob, frame.parameters0, h.b);
        a.uv = uv_at(p, h.b);
        a.id = float(p.object + 1u);
    }
    aov[pixel - push.first_row * uint(frame.size.x)] = a;
}
