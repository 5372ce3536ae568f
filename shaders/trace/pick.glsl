// First hits of given rays: the cursor's place on the displaced surface.
layout(set = 0, binding = kBindPickRays, scalar) readonly buffer PickRayBlock { PickRay pick_rays[]; };
layout(set = 0, binding = kBindPickResults, scalar) writeonly buffer PickResultBlock { PickResult pick_results[]; };

void pick_main(int invocation) {
    bool has_ray = invocation < int(push.ray_count);
    int i = min(invocation, int(push.ray_count) - 1);
    PickRay ray = pick_rays[i];
    PickResult r;
    r.t = -1.0;
    r.object = 0u;
    r.face = 0u;
    r.b1 = 0.0;
    r.b2 = 0.0;
    r.normal = vec3(0.0);
    TraceHit h = trace_ray(ray.origin, ray.direction, 0.0, has_ray ? ray.t_max : kNoReach, false, uint(i));
    if (!has_ray) return;
    if (h.primitive != kNoHit) {
        Primitive p = primitives[h.primitive];
        r.t = h.t;
        r.object = p.object;
        r.face = p.face;
        r.b1 = h.b.x;
        r.b2 = h.b.y;
        r.normal = geometric_normal(p, normals[h.primitive], object_data(p.object), h.b);
    }
    pick_results[i] = r;
}
