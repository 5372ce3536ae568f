// What a traversal reads most, two words at a time. Where lanes part, lavapipe makes one gather of each word that is
// read by address (of a storage buffer, a loop over the lanes), and of each pair of words one too: gathers are half of
// what a node costs on a processor, and pairs take 5 to 6% off the frame, of every method.
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require

layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer WordPairs { uint64_t at[]; };

uvec2 word_pair(uvec2 address, uint i) { return unpackUint2x32(WordPairs(address).at[i]); }

// The layouts are those of shared.h.
Primitive primitive_of_pairs(uvec2 v[16]) {
    Primitive p;
    p.origin = uintBitsToFloat(uvec3(v[0], v[1].x));
    p.w_low = uintBitsToFloat(v[1].y);
    p.tangent = uintBitsToFloat(uvec3(v[2], v[3].x));
    p.w_high = uintBitsToFloat(v[3].y);
    p.ng = uintBitsToFloat(uvec3(v[4], v[5].x));
    p.q1x = uintBitsToFloat(v[5].y);
    p.q2 = uintBitsToFloat(v[6]);
    p.shift0 = uintBitsToFloat(v[7]);
    p.shift1 = uintBitsToFloat(v[8]);
    p.shift2 = uintBitsToFloat(v[9]);
    p.tx0 = uintBitsToFloat(v[10]);
    p.tx1 = uintBitsToFloat(v[11]);
    p.tx2 = uintBitsToFloat(v[12]);
    p.base = v[13].x;
    p.base_high = v[13].y;
    p.face = v[14].x;
    p.object = v[14].y;
    p.flags = v[15].x;
    p.shell_margin = uintBitsToFloat(v[15].y);
    return p;
}

Primitive load_primitive(uint id) {
    uvec2 v[16];
    for (uint i = 0u; i < 16u; ++i) v[i] = word_pair(frame.primitives, 16u * id + i);
    return primitive_of_pairs(v);
}

BvhNode load_node(uint index) {
    uvec2 v[8];
    for (uint i = 0u; i < 8u; ++i) v[i] = word_pair(frame.bvh, 8u * index + i);
    BvhNode n;
    n.origin = uintBitsToFloat(uvec3(v[0], v[1].x));
    n.exponents = v[1].y;
    n.child = uvec4(v[2], v[3]);
    n.low = uvec3(v[4], v[5].x);
    n.high = uvec3(v[5].y, v[6]);
    n.slab_low = v[7].x;
    n.slab_high = v[7].y;
    return n;
}
