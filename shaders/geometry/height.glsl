// Bilinear heights of the displacement map. The four texels of a cell come from one gather at the corner they share,
// so that no device's filtering precision enters; the weights are ours.
//   height_quad(object, cell): texels (0,0) (1,0) (0,1) (1,1) of the cell, in [0, 1]: given by the including side.
// Cells are whole numbers kept as floats: lavapipe turns a float into an integer one lane at a time (measured: a third of
// what a stretch or a sample costs).
#ifndef RELIEVO_HEIGHT_GLSL
#define RELIEVO_HEIGHT_GLSL

FUNC float bilinear(vec4 quad, vec2 f) {
    float low = quad.x + f.x * (quad.y - quad.x);
    float high = quad.z + f.x * (quad.w - quad.z);
    return low + f.y * (high - low);
}

// Derivatives of `bilinear` by f.
FUNC vec2 bilinear_gradient(vec4 q, vec2 f) {
    return vec2((q.y - q.x) * (1.0f - f.y) + (q.w - q.z) * f.y, (q.z - q.x) * (1.0f - f.x) + (q.w - q.y) * f.x);
}

// Map value at texel coordinates `tx` relative to `base`.
FUNC float map_value(uint object, vec2 base, vec2 tx) {
    vec2 cell = floor(tx);
    return bilinear(height_quad(object, base + cell), tx - cell);
}

// Gradient of the map value per texel, over half a texel to either side: continuous, unlike the cell's own.
FUNC vec2 smooth_gradient(uint object, vec2 base, vec2 tx) {
    float x = map_value(object, base, tx + vec2(0.5f, 0.0f)) - map_value(object, base, tx - vec2(0.5f, 0.0f));
    float y = map_value(object, base, tx + vec2(0.0f, 0.5f)) - map_value(object, base, tx - vec2(0.0f, 0.5f));
    return vec2(x, y);
}

// The cell's own gradient: the derivative of the bilinear surface itself.
FUNC vec2 cell_gradient(uint object, vec2 base, vec2 tx) {
    vec2 cell = floor(tx);
    return bilinear_gradient(height_quad(object, base + cell), tx - cell);
}

#endif
