// One sample a pixel of the window: traced, shaded, added to the accumulation, tone mapped for display.
#include "camera.glsl"
#include "shade.glsl"

layout(set = 0, binding = kBindAccumulation, scalar) buffer AccumulationBlock { vec4 accumulation[]; };
layout(set = 0, binding = kBindCounts, scalar) buffer CountBlock { uint counts[]; };
layout(set = 0, binding = kBindDisplay, rgba8) uniform writeonly image2D display;

vec3 tone_map(vec3 c) {  // Narkowicz 2015, a fit of the ACES reference transform; then sRGB
    c *= 0.8;
    c = clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(max(c, vec3(1e-8)), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

Shading shading_at(TraceHit h, vec3 d) {
    Primitive p = primitives[h.primitive];
    PrimitiveNormals n = normals[h.primitive];
    Shading s;
    s.ob = object_data(p.object);
    s.ob.albedo = albedo_at(p, s.ob, h.b);
    s.point = frame.eye + d * h.t;
    s.view = -d;
    s.ng = geometric_normal(p, n, s.ob, h.b);
    s.ns = shading_normal(p, n, s.ob, frame.parameters0, h.b);
    s.base_ng = surface_normal(p, n, s.ob, h.b, vec2(0.0));
    s.base_ns = normalize(base_normal(n, h.b));
    s.bulge = bulge_over(p, n, h.b);
    // The base normal's side is outside; the inside is lit as seen.
    if (dot(s.ng, s.view) < 0.0) {
        s.ng = -s.ng;
        s.ns = -s.ns;
        s.bulge = vec3(0.0);
    }
    // A shading normal turned away from the viewer would be black: bend it back.
    float back = dot(s.ns, s.view);
    if (back < 0.01) s.ns = normalize(s.ns + s.view * (0.01 - back));
    s.offset_point = s.point + s.ng * s.ob.ray_offset;
    return s;
}

vec3 unshadowed_lights(Shading s, uint pixel, bool preview) {
    vec3 sum = vec3(0.0);
    SecondaryRay ray;
    for (uint i = 0u; i < frame.light_count; ++i)
        if (secondary_ray(s, i, pixel, preview, ray)) sum += ray.radiance;
    return sum;
}

// The camera's ray, then one after the other those from the surface that bring light, by one call: compilers copy the
// traversal and the method's intersection to every call, and a processor's takes seconds and megabytes for each. All
// invocations trace the same kind of ray at a time, or none (trace_ray() may need them all).
vec4 radiance_along(vec3 camera_ray, uint pixel, bool preview, bool has_ray) {
    Shading s;
    SecondaryRay ray;
    vec4 sum = vec4(0.0);
    ray.origin = frame.eye;
    ray.direction = camera_ray;
    ray.reach = has_ray ? kFar : kNoReach;
    ray.radiance = vec3(0.0);
    uint traced = 0u, last = kShadows ? secondary_rays(preview) : 0u;
    do {
        TraceHit h = trace_ray(ray.origin, ray.direction, 0.0, ray.reach, traced > 0u, pixel);
        bool hit = h.primitive != kNoHit;
        if (traced > 0u) {
            if (!hit && ray.reach >= 0.0) sum.rgb += ray.radiance;
        } else if (hit) {
            s = shading_at(h, camera_ray);
            sum.a = 1.0;
        } else {
            sum.rgb = sky_radiance(camera_ray);
        }
        if (!(sum.a > 0.0 && traced < last && secondary_ray(s, traced, pixel, preview, ray))) ray.reach = kNoReach;
    } while (traced++ < last);
    if (sum.a > 0.0) {
        if (!kShadows) sum.rgb += unshadowed_lights(s, pixel, preview);
        sum.rgb += unshadowed_sky(s, preview);
    }
    return sum;
}

void beauty_main(ivec2 local) {
    ivec2 px;
    bool has_pixel = window_pixel(local, px);
    uint pixel = pixel_index(px);
    bool preview = push.preview != 0u;
    vec2 jitter = preview || push.sample_index == 0u
                      ? vec2(0.5)
                      : vec2(random_at(pixel, push.sample_index, 0x50000000u), random_at(pixel, push.sample_index, 0x50000001u));
    vec4 value = radiance_along(camera_direction(vec2(px) + jitter), pixel, preview, has_pixel);
    if (!has_pixel) return;
    if (any(isnan(value)) || any(isinf(value))) value = vec4(0.0);
    // A preview never mixes with real samples: the first of those replaces it.
    uint count = preview ? 0u : counts[pixel];
    vec4 sum = count == 0u ? value : accumulation[pixel] + value;
    accumulation[pixel] = sum;
    counts[pixel] = preview ? 0u : count + 1u;
    imageStore(display, px, vec4(tone_map(sum.rgb / float(max(count + 1u, 1u))), 1.0));
}
