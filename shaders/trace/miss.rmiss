#version 460
#extension GL_GOOGLE_include_directive : require
// Miss of the pipeline path.
#extension GL_EXT_ray_tracing : require
#include "bindings.glsl"

layout(location = 0) rayPayloadInEXT TraceHit payload;

void main() { payload.primitive = kNoHit; }
