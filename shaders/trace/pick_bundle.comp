#version 460
#extension GL_GOOGLE_include_directive : require
// Compute entry of the pass, tracing through the program's own tree of boxes by bundles of rays.
#include "bundle.glsl"
#include "pick.glsl"

void main() { pick_main(invocation_index()); }
