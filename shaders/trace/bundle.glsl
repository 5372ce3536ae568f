// Tracing through the program's own tree of boxes (renderer/wide_bvh.h) for processors whose drivers run eight invocations
// side by side: a subgroup's eight rays walk the tree together, after Wald and others 2001 ("Interactive Rendering with
// Coherent Ray Tracing"). bvh.glsl, where each ray walks alone, costs such a processor more: it reads nodes and primitives by
// one gather a word, lane after lane; here the lanes read a node by one, and a primitive by two, and hand its words around.
// What deviates: rays need not be coherent, only then it is fast; a node's children are sorted for all rays at once, by
// the first entry; the stack lies across the lanes of registers; each child keeps which rays met it, so that a primitive is
// tested by those alone.
//
// All invocations of a subgroup call trace_ray() together.
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_shuffle : require
#include "bindings.glsl"
#include "compute.glsl"
#include "node_boxes.glsl"

const uint kLanes = 8u;
const uint kStackParts = kBvhStack / kLanes;

uint lane() { return gl_SubgroupInvocationID; }

float latest_of_bundle(float t) {
    t = latest(t, subgroupShuffle(t, lane() ^ 1u));
    t = latest(t, subgroupShuffle(t, lane() ^ 2u));
    return latest(t, subgroupShuffle(t, lane() ^ 4u));
}

float earliest_of_bundle(float t) {
    t = earliest(t, subgroupShuffle(t, lane() ^ 1u));
    t = earliest(t, subgroupShuffle(t, lane() ^ 2u));
    return earliest(t, subgroupShuffle(t, lane() ^ 4u));
}

// Word i of what the lanes hold, two words each.
uint shared_word(uvec2 words, uint i) {
    uint even = subgroupShuffle(words.x, i >> 1u), odd = subgroupShuffle(words.y, i >> 1u);
    return (i & 1u) == 0u ? even : odd;
}

Primitive load_primitive_together(uint id) {
    uvec2 low = word_pair(frame.primitives, 16u * id + lane()), high = word_pair(frame.primitives, 16u * id + 8u + lane());
    uvec2 pairs[16];
    for (uint i = 0u; i < 8u; ++i) {
        pairs[i] = uvec2(subgroupShuffle(low.x, i), subgroupShuffle(low.y, i));
        pairs[8u + i] = uvec2(subgroupShuffle(high.x, i), subgroupShuffle(high.y, i));
    }
    return primitive_of_pairs(pairs);
}

struct BundleRay {
    vec3 origin, direction, inverse;
    uvec3 near, far;  // of each axis: which of a node's six words of bounds (low, then high) the ray meets first, and last
    float start;      // nothing of the scene comes before, for any ray of the bundle
};

// How children are sorted: the distance from the bundle's start, rounded down to 22 bits, the rays that met the child (a bit
// a lane), and the child's place in its node.
const uint kKeyDistance = ~1023u, kKeyNotMet = ~0u;
uint distance_key(BundleRay r, float t) { return floatBitsToUint(max(t - r.start, 0.0)) & kKeyDistance; }
uint rays_of_key(uint key) { return (key >> 2u) & 255u; }
uint place_of_key(uint key) { return key & 3u; }

// Nodes that wait, all the same for each ray: slot i is lane i % 8 of part i / 8.
uint waiting_key[kStackParts], waiting_node[kStackParts];
uint waiting_count;

// Those of the children with ranks 1 to met - 1 that come to this part: the nearest comes to lie on top. Keys are sorted.
void wait_in_part(uint part, uint keys, uint children, uint met) {
    uint rank = waiting_count + met - 1u - (part * kLanes + lane());
    bool here = rank - 1u < met - 1u;
    uint key = subgroupShuffle(keys, rank & 7u), node = subgroupShuffle(children, place_of_key(key));
    waiting_key[part] = here ? key : waiting_key[part];
    waiting_node[part] = here ? node : waiting_node[part];
}

void wait_for_turn(uint keys, uint children, uint met) {
    wait_in_part(0u, keys, children, met);
    wait_in_part(1u, keys, children, met);
    if (waiting_count + met > 2u * kLanes)
        for (uint part = 2u; part < kStackParts; ++part) wait_in_part(part, keys, children, met);
    waiting_count += met - 1u;
}

// The last that waits and that some ray may still want; kBvhNone at the end.
uint next_waiting(uint limit, out uint key) {
    uint node;
    do {
        node = kBvhNone;
        key = 0u;
        if (waiting_count > 0u) {
            uint part = --waiting_count / kLanes, at = waiting_count % kLanes;
            key = subgroupShuffle(part == 0u ? waiting_key[0] : waiting_key[1], at);
            node = subgroupShuffle(part == 0u ? waiting_node[0] : waiting_node[1], at);
            if (part > 1u) {
                for (uint i = 2u; i < kStackParts; ++i) {
                    key = part == i ? subgroupShuffle(waiting_key[i], at) : key;
                    node = part == i ? subgroupShuffle(waiting_node[i], at) : node;
                }
            }
        }
    } while (key > limit);
    return node;
}

// Up to which key a node may hold something for a ray that is traced no further than its reach (negative: no more at all).
uint limit_of(BundleRay r, float furthest) { return furthest < 0.0 ? 0u : distance_key(r, furthest) | ~kKeyDistance; }

// Lane i gets the least of t[i & 3] over the lanes, and the union of rays[i & 3].
void gather_children(vec4 t, uvec4 rays, out float least, out uint all) {
    bool odd = (lane() & 1u) != 0u, upper = (lane() & 2u) != 0u;
    float a = earliest(odd ? t.y : t.x, subgroupShuffle(odd ? t.x : t.y, lane() ^ 1u));
    float b = earliest(odd ? t.w : t.z, subgroupShuffle(odd ? t.z : t.w, lane() ^ 1u));
    a = earliest(upper ? b : a, subgroupShuffle(upper ? a : b, lane() ^ 2u));
    least = earliest(a, subgroupShuffle(a, lane() ^ 4u));
    uint c = (odd ? rays.y : rays.x) | subgroupShuffle(odd ? rays.x : rays.y, lane() ^ 1u);
    uint d = (odd ? rays.w : rays.z) | subgroupShuffle(odd ? rays.z : rays.w, lane() ^ 1u);
    c = (upper ? d : c) | subgroupShuffle(upper ? c : d, lane() ^ 2u);
    all = c | subgroupShuffle(c, lane() ^ 4u);
}

// How many of a node's children some ray meets between t_min and its reach. Lane i & 3 of `children` is child i, of `keys` the
// i-th nearest's key.
uint meet_children(uint node, BundleRay r, float t_min, float reach, out uint keys, out uint children) {
    // Words of gpu::BvhNode: 0 origin, 3 exponents, 4 children, 8 low, 11 high, 14 the slab's low and high.
    uvec2 words = word_pair(frame.bvh, kLanes * node + lane());
    children = shared_word(words, 4u + (lane() & 3u));
    vec3 origin = uintBitsToFloat(uvec3(shared_word(words, 0u), shared_word(words, 1u), shared_word(words, 2u)));
    uint exponents = shared_word(words, 3u);
    vec3 steps = steps_of(exponents), away = origin - r.origin, a = steps * r.inverse, b = away * r.inverse;
    Slab slab = slab_of(exponents, steps, away, r.direction);
    uint slab_near = slab.step < 0.0 ? 7u : 6u;
    vec4 bounds = bytes_of(shared_word(words, 8u + lane()));
    vec4 t;
    uvec4 rays;
    for (int i = 0; i < 4; ++i) {
        vec3 enter = vec3(subgroupShuffle(bounds[i], r.near.x), subgroupShuffle(bounds[i], r.near.y),
                          subgroupShuffle(bounds[i], r.near.z)) * a + b;
        vec3 leave = vec3(subgroupShuffle(bounds[i], r.far.x), subgroupShuffle(bounds[i], r.far.y),
                          subgroupShuffle(bounds[i], r.far.z)) * a + b;
        float slab_enter = subgroupShuffle(bounds[i], slab_near) * slab.step + slab.enter;
        float slab_leave = subgroupShuffle(bounds[i], slab_near ^ 1u) * slab.step + slab.leave;
        float entry = latest(latest(latest(enter.x, enter.y), latest(enter.z, t_min)), slab_enter);
        float end = earliest(earliest(earliest(leave.x, leave.y), earliest(leave.z, reach)), slab_leave);
        bool met = entry <= end * kLeaveSlack;
        t[i] = met ? entry : kNotMet;
        rays[i] = met ? 1u << lane() : 0u;
    }
    float least;
    uint all;
    gather_children(t, rays, least, all);
    uint key = children == kBvhNone || all == 0u ? kKeyNotMet : distance_key(r, least) | all << 2u | (lane() & 3u);
    uvec4 k = uvec4(subgroupShuffle(key, 0u), subgroupShuffle(key, 1u), subgroupShuffle(key, 2u), subgroupShuffle(key, 3u));
    uvec4 pairs = uvec4(min(k.x, k.y), max(k.x, k.y), min(k.z, k.w), max(k.z, k.w));
    uint first = min(pairs.x, pairs.z), last = max(pairs.y, pairs.w), one = max(pairs.x, pairs.z), other = min(pairs.y, pairs.w);
    k = uvec4(first, min(one, other), max(one, other), last);
    bool odd = (lane() & 1u) != 0u;
    keys = (lane() & 2u) != 0u ? odd ? k.w : k.z : odd ? k.y : k.x;
    uvec4 counted = mix(uvec4(0u), uvec4(1u), notEqual(k, uvec4(kKeyNotMet)));
    return counted.x + counted.y + counted.z + counted.w;
}

// Where the first ray of the bundle may meet the scene; those without a way do not count.
float bundle_start(BundleRay r, float t_min, float t_max) {
    uvec2 words = word_pair(frame.bvh, lane());
    vec3 low = uintBitsToFloat(uvec3(shared_word(words, 0u), shared_word(words, 1u), shared_word(words, 2u)));
    vec3 high = low + 255.0 * steps_of(shared_word(words, 3u));
    vec3 enter = min((low - r.origin) * r.inverse, (high - r.origin) * r.inverse);
    return earliest_of_bundle(t_max < t_min ? kNotMet : max(max(enter.x, enter.y), max(enter.z, t_min)));
}

// Every node is met at most once, whatever the rays' numbers are: the walk always ends.
TraceHit trace_ray(vec3 origin, vec3 direction, float t_min, float t_max, bool any_hit, uint pixel) {
    TraceHit best;
    best.primitive = kNoHit;
    best.t = t_max;
    best.b = vec2(0.0);
    BundleRay r;
    r.origin = origin;
    r.direction = direction;
    r.inverse = inverse_of(direction);
    bvec3 back = lessThan(r.inverse, vec3(0.0));
    r.near = uvec3(0u, 1u, 2u) + mix(uvec3(0u), uvec3(3u), back);
    r.far = uvec3(3u, 4u, 5u) - mix(uvec3(0u), uvec3(3u), back);
    r.start = bundle_start(r, t_min, t_max);
    float reach = t_max;
    uint limit = limit_of(r, latest_of_bundle(reach));
    waiting_count = 0u;
    uint next = limit == 0u ? kBvhNone : 0u, key;
    if (next != kBvhNone) {
        do {
            if (next < kBvhLeaf) {
                do {
                    uint keys, children, met = meet_children(next, r, t_min, reach, keys, children);
                    if (met > 1u) wait_for_turn(keys, children, met);
                    if (met > 0u) {
                        key = subgroupShuffle(keys, 0u);
                        next = subgroupShuffle(children, place_of_key(key));
                    } else {
                        next = next_waiting(limit, key);
                    }
                } while (next < kBvhLeaf);
            }
            if (next != kBvhNone) {
                uint box = next & ~kBvhLeaf, id = primitive_of_box(box);
                Primitive p = load_primitive_together(id);
                bool met_box = (rays_of_key(key) & (1u << lane())) != 0u && key <= limit_of(r, reach);
                if (met_box && test_primitive(p, id, box, origin, direction, t_min, pixel, best))
                    reach = any_hit ? kNoReach : best.t;
                limit = limit_of(r, latest_of_bundle(reach));
                next = next_waiting(limit, key);
            }
        } while (next != kBvhNone);
    }
    flush_counts(pixel);
    return best;
}
