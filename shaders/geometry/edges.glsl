// Which hits belong to a triangle: neighbours overlap by a margin, so that no ray slips between them.
#ifndef RELIEVO_EDGES_GLSL
#define RELIEVO_EDGES_GLSL

const float kSharedEdgeMargin = 1e-5f;      // barycentric,
const float kOpenEdgeMargin = 0.0f;         // at an edge without neighbour: beyond it stands nothing
const float kMostSharedEdgeMargin = 1e-3f;  // or by more where a far ray's rounding asks for it

// Of the edges opposite vertices 0, 1 and 2, barycentric.
FUNC vec3 edge_margins(Primitive p, float rounding) {
    float inner = min(kSharedEdgeMargin + rounding / min(p.q1x, p.q2.y), kMostSharedEdgeMargin);
    return vec3((p.flags & kPrimitiveOpenEdge0) != 0u ? kOpenEdgeMargin : inner,
                (p.flags & (kPrimitiveOpenEdge0 << 1)) != 0u ? kOpenEdgeMargin : inner,
                (p.flags & (kPrimitiveOpenEdge0 << 2)) != 0u ? kOpenEdgeMargin : inner);
}

FUNC bool within_edges(vec2 b, vec3 margin) {
    return b.x >= -margin.y && b.y >= -margin.z && 1.0f - b.x - b.y >= -margin.x;
}

#endif
