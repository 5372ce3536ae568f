#version 460
#extension GL_GOOGLE_include_directive : require
// Compute entry of the pass, tracing by ray query.
#include "query.glsl"
#include "pick.glsl"

void main() { pick_main(invocation_index()); }
