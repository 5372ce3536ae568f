#version 460
#extension GL_GOOGLE_include_directive : require
// Compute entry of the pass, tracing through the program's own tree of boxes by bundles of rays.
#include "bundle.glsl"
#include "beauty.glsl"

void main() { beauty_main(invocation_pixel()); }
