// Tracing through the program's own tree of boxes (renderer/wide_bvh.h), for processors: their drivers' trees are worse,
// and so is what they make of a ray query. Each invocation's ray walks alone; see also bundle.glsl.
#include "bindings.glsl"
#include "compute.glsl"
#include "node_boxes.glsl"

// Where the ray enters each child's box; kNotMet for those that it does not meet before t_max.
vec4 child_entries(BvhNode n, vec3 origin, vec3 direction, vec3 inverse, float t_min, float t_max) {
    vec3 steps = steps_of(n.exponents), away = n.origin - origin, a = steps * inverse, b = away * inverse;
    Slab slab = slab_of(n.exponents, steps, away, direction);
    bool turned = slab.step < 0.0;
    bvec3 back = lessThan(inverse, vec3(0.0));
    uvec3 first = mix(n.low, n.high, back), last = mix(n.high, n.low, back);
    vec4 enter = latest(latest(bytes_of(first.x) * a.x + b.x, bytes_of(first.y) * a.y + b.y),
                        latest(bytes_of(first.z) * a.z + b.z, vec4(t_min)));
    enter = latest(enter, bytes_of(turned ? n.slab_high : n.slab_low) * slab.step + slab.enter);
    vec4 leave = earliest(earliest(bytes_of(last.x) * a.x + b.x, bytes_of(last.y) * a.y + b.y),
                          earliest(bytes_of(last.z) * a.z + b.z, vec4(t_max)));
    leave = earliest(leave, bytes_of(turned ? n.slab_low : n.slab_high) * slab.step + slab.leave);
    bvec4 met = lessThanEqual(enter, leave * kLeaveSlack);
    return mix(vec4(kNotMet), enter, bvec4(uvec4(met) & uvec4(notEqual(n.child, uvec4(kBvhNone)))));
}

void order(inout float ka, inout float kb, inout uint a, inout uint b) {
    bool turn = kb < ka;
    float k = turn ? kb : ka;
    kb = turn ? ka : kb;
    ka = k;
    uint c = turn ? b : a;
    b = turn ? a : b;
    a = c;
}

// Nodes that wait, and where the ray enters them; below them the end of the walk.
uint waiting[kBvhStack + 1u];
float waiting_entry[kBvhStack + 1u];
int waiting_count;

void wait(float entry, uint node) {
    if (!(entry < kNotMet)) return;
    waiting_entry[waiting_count] = entry;
    waiting[waiting_count++] = node;
}

// The last that waits and does not lie behind the nearest hit.
uint next_waiting(float t) {
    do --waiting_count;
    while (waiting_entry[waiting_count] > t);
    return waiting[waiting_count];
}

// Every node is met at most once, whatever the ray's numbers are: the walk always ends.
// Loops ask at their end whether to go on: at their start, lavapipe would run through them once more without a lane.
TraceHit trace_ray(vec3 origin, vec3 direction, float t_min, float t_max, bool any_hit, uint pixel) {
    TraceHit best;
    best.primitive = kNoHit;
    best.t = t_max;
    best.b = vec2(0.0);
    vec3 inverse = inverse_of(direction);
    waiting[0] = kBvhNone;
    waiting_entry[0] = -kNotMet;
    waiting_count = 1;
    uint next = 0u;
    do {
        if (next < kBvhLeaf) {
            do {
                BvhNode n = load_node(next);
                vec4 k = child_entries(n, origin, direction, inverse, t_min, best.t);
                uvec4 c = n.child;
                order(k.x, k.y, c.x, c.y);
                order(k.z, k.w, c.z, c.w);
                order(k.x, k.z, c.x, c.z);
                order(k.y, k.w, c.y, c.w);
                order(k.y, k.z, c.y, c.z);
                wait(k.w, c.w);
                wait(k.z, c.z);
                wait(k.y, c.y);
                next = k.x < kNotMet ? c.x : next_waiting(best.t);
            } while (next < kBvhLeaf);
        }
        if (next != kBvhNone) {
            bool met = test_box(next & ~kBvhLeaf, origin, direction, t_min, pixel, best);
            next = met && any_hit ? kBvhNone : next_waiting(best.t);
        }
    } while (next != kBvhNone);
    flush_counts(pixel);
    return best;
}
