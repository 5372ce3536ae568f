// Where a triangle lies in the height source's texels.
#ifndef RELIEVO_TEXELS_GLSL
#define RELIEVO_TEXELS_GLSL

// The whole texel that the primitive's coordinates are relative to.
FUNC vec2 primitive_base(Primitive p) {
    ivec2 base = ivec2(int(p.base & 0xffffu), int(p.base >> 16));
    if (kProcedural) base += ivec2(int(p.base_high << 16), int(p.base_high & 0xffff0000u));
    return vec2(float(base.x), float(base.y));
}

FUNC vec2 texel_at(Primitive p, vec2 b) { return p.tx0 * (1.0f - b.x - b.y) + p.tx1 * b.x + p.tx2 * b.y; }

#endif
