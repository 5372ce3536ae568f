#version 460
#extension GL_GOOGLE_include_directive : require
// Compute entry of the pass, tracing by ray query.
#include "query.glsl"
#include "aov.glsl"

void main() { aov_main(invocation_pixel()); }
