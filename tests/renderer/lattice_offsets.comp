#version 460
#extension GL_GOOGLE_include_directive : require
// What the shaders make of procedural heights' lattice, for lattice_offsets_test.cpp: where virtual texels lie in it, and the
// exemplar's offsets at vertices.
#include "bindings.glsl"
#include "lattice_offsets.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = kBindPickRays, scalar) readonly buffer QuestionBlock { LatticeQuestion questions[]; };
layout(set = 0, binding = kBindPickResults, scalar) writeonly buffer AnswerBlock { LatticeAnswer answers[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    LatticeQuestion question = questions[i];
    ProceduralData data = procedural_data(0u);
    LatticeAnswer answer;
    lattice_coordinates(data, question.texel, answer.x, answer.y);
    LatticePlace place = lattice_place(answer.x, answer.y);
    answer.beyond = place.beyond ? 1 : 0;
    answer.home = exemplar_home(0u, question.texel);
    answer.texel_shift = vertex_shift(0u, data.seed, lattice_vertex(place.square, place.beyond, 0));
    answer.vertex_shift = vertex_shift(0u, question.seed, question.vertex);
    answers[i] = answer;
}
