// What lattice_offsets.comp is asked and what it answers, as shaders/shared.h has its structs.
#ifndef RELIEVO_LATTICE_OFFSETS_H
#define RELIEVO_LATTICE_OFFSETS_H

#ifdef __cplusplus
#include "shaders/shared.h"
namespace relievo::gpu {
#endif

struct LatticeQuestion {
    ivec2 texel;   // virtual
    ivec2 vertex;  // of the lattice
    uint seed;     // for the vertex; the texel's is the source's
};

struct LatticeAnswer {
    uvec2 x, y;          // the texel's lattice coordinates, fixed point
    int beyond;          // 1: in the second half of its square
    ivec2 home;          // the texel wrapped into the exemplar
    ivec2 texel_shift;   // offset at the right angle of the texel's half,
    ivec2 vertex_shift;  // and at the vertex that was asked for
};

#ifdef __cplusplus
}  // namespace relievo::gpu
#endif
#endif
