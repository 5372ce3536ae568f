// Descriptors and specialisation constants of every entry point, and the map access that geometry/ asks for.
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_nonuniform_qualifier : require
#include "../shared.h"

layout(constant_id = 0) const uint kObjects = 1u;
layout(constant_id = 1) const bool kShadows = true;
layout(constant_id = 2) const bool kOpacity = true;
layout(constant_id = 3) const bool kGloss = true;
layout(constant_id = 4) const bool kSky = true;
layout(constant_id = 5) const uint kNotes = 0u;  // kNotes* of shared.h
layout(constant_id = 6) const bool kSearch = true;
layout(constant_id = 7) const bool kProcedural = true;
layout(constant_id = 8) const bool kAlbedo = true;
layout(constant_id = 9) const bool kSlants = true;

layout(set = 0, binding = kBindFrame, scalar) uniform FrameBlock { FrameData frame; };
layout(set = 0, binding = kBindPrimitives, scalar) readonly buffer PrimitiveBlock { Primitive primitives[]; };
layout(set = 0, binding = kBindNormals, scalar) readonly buffer NormalBlock { PrimitiveNormals normals[]; };
layout(set = 0, binding = kBindObjects, scalar) readonly buffer ObjectBlock { ObjectData objects[]; };
layout(set = 0, binding = kBindMaps) uniform sampler2D maps[kObjects];
layout(set = 0, binding = kBindOpacity) uniform sampler2D opacity_maps[kObjects];
layout(set = 0, binding = kBindPyramids) uniform sampler2D pyramids[kObjects];
layout(set = 0, binding = kBindSlabs) uniform isampler2D slabs[kObjects];
layout(set = 0, binding = kBindProcedural, scalar) readonly buffer ProceduralBlock { ProceduralData procedural_sources[]; };
layout(set = 0, binding = kBindAlbedo) uniform sampler2D albedo_maps[kObjects];
layout(push_constant, scalar) uniform PushBlock { PushData push; };

#include "../geometry/dialect.glsl"
#include "../geometry/hash.glsl"
#include "../geometry/texels.glsl"
#include "notes.glsl"

// Of the triangle that is being asked: few methods want them before the hit.
PrimitiveNormals primitive_normals() { return normals[asked_primitive]; }

ObjectData object_data(uint object) { return objects[kObjects == 1u ? 0u : object]; }

// One gather at the corner that the four texels share: far from any texel's border, so its rounding cannot matter.
vec4 map_quad(uint object, vec2 cell) {
    vec4 g;  // (0,1) (1,1) (1,0) (0,0)
    if (kObjects == 1u) {
        g = textureGather(maps[0], (cell + 1.0) / vec2(objects[0].map_size));
    } else {
        g = textureGather(maps[nonuniformEXT(object)], (cell + 1.0) / vec2(objects[object].map_size));
    }
    return vec4(g.w, g.z, g.x, g.y);
}

// Of a pyramid over the map, which may have fewer levels than are asked for.
int level_of_map(ivec2 map_size, int level) { return min(level, max(findMSB(max(map_size.x, map_size.y)), 1)); }

// The level's node over the cell, which lies inside the map.
ivec2 node_of_cell(ivec2 map_size, int level, ivec2 cell) {
    return min(cell >> level, max(map_size >> level, ivec2(1)) - 1);
}

vec2 pyramid_node(uint object, ivec2 map_size, int level, ivec2 cell) {
    level = level_of_map(map_size, level);
    ivec2 node = node_of_cell(map_size, level, cell);
    if (kObjects == 1u) return texelFetch(pyramids[0], node, level - 1).rg;
    return texelFetch(pyramids[nonuniformEXT(object)], node, level - 1).rg;
}

#include "exemplar.glsl"

bool is_procedural(uint object) { return kProcedural && procedural_data(object).used != kHeightsOfMap; }

// Heights of the texels (0,0) (1,0) (0,1) (1,1) of a cell between texel centres.
vec4 height_quad(uint object, vec2 cell) {
    count_fetch();
    if (is_procedural(object)) return procedural_quad(object, signed_whole(cell));
    return map_quad(object, cell);
}

// Where the cell lies in the map's first period; on its border where it lies beyond under clamp.
ivec2 cell_in_map(ObjectData ob, vec2 cell) {
    vec2 size = vec2(ob.map_size);
    if (ob.clamp_wrap == 0u) cell -= size * floor((cell + 0.5) / size);
    return whole(clamp(cell, vec2(0.0), size - 1.0));
}

// Least and greatest height over the cells (between texel centres) from `cell` on, 2^level + 1 a side; over a map, over the
// two by two nodes of 2^level cells a side beginning with the node that holds `cell`. Levels 1 to kPyramidLevels; a small
// map's own last level, one node, holds all of it.
vec2 map_bounds(uint object, int level, vec2 cell) {
    count_fetch();
    if (is_procedural(object)) return procedural_bounds(object, signed_whole(cell), ivec2((1 << level) + 1));
    ObjectData ob = object_data(object);
    return pyramid_node(object, ob.map_size, level, cell_in_map(ob, cell));
}

// The same of heights about a plane.
HeightSlab height_slab(uint object, int level, vec2 cell) {
    if (is_procedural(object)) {
        HeightSlab slab;
        slab.bounds = map_bounds(object, level, cell);
        slab.middle = slab.slope = vec2(0.0);
        return slab;
    }
    count_fetch();
    ObjectData ob = object_data(object);
    ivec2 inside = cell_in_map(ob, cell);
    level = level_of_map(ob.map_size, level);
    ivec2 node = node_of_cell(ob.map_size, level, inside);
    vec4 packed;
    if (kObjects == 1u) {
        packed = vec4(texelFetch(slabs[0], node, level - 1 - ob.slabs_left_out));
    } else {
        packed = vec4(texelFetch(slabs[nonuniformEXT(object)], node, level - 1 - ob.slabs_left_out));
    }
    return unpacked_slab(packed, level, vec2(((node + 1) << level) - inside));
}

#include "../geometry/height.glsl"
#include "../geometry/surface.glsl"
#include "../geometry/prism.glsl"
#include "../geometry/shell.glsl"
#include "../geometry/edges.glsl"

// Texture coordinates of a hit, in the map's own [0, 1) period where it repeats.
vec2 uv_at(Primitive p, vec2 b) {
    if (is_procedural(p.object)) {
        ProceduralData data = procedural_data(p.object);
        return data.uv_start + (primitive_base(p) * data.uv_scale + (texel_at(p, b) + 0.5) * data.uv_scale);
    }
    vec2 texel = primitive_base(p) + texel_at(p, b) + 0.5;
    return texel / vec2(object_data(p.object).map_size);
}

// World units that a pixel is wide at distance 1.
float pixel_spread() { return 2.0 * length(frame.right) / float(frame.size.x); }

// The method's fifth parameter.
float fifth_parameter() { return frame.parameters1.x; }

// Under 0.5 the surface has a hole.
bool opaque_at(Primitive p, vec2 b) {
    if (!kOpacity) return true;
    vec2 uv = uv_at(p, b);
    if (kObjects == 1u) return textureLod(opacity_maps[0], uv, 0.0).r >= 0.5;
    return textureLod(opacity_maps[nonuniformEXT(p.object)], uv, 0.0).r >= 0.5;
}

// Linear: the material's, or its map's in the place of it.
vec3 albedo_at(Primitive p, ObjectData ob, vec2 b) {
    if (!kAlbedo || ob.albedo_map == 0u) return ob.albedo;
    vec2 uv = uv_at(p, b);
    if (kObjects == 1u) return textureLod(albedo_maps[0], uv, 0.0).rgb;
    return textureLod(albedo_maps[nonuniformEXT(p.object)], uv, 0.0).rgb;
}

void note_hit(Primitive p, SurfaceHit hit) {
    if (kNotes != kNotesLog) return;
    note(kNoteHit, hit.t, texel_at(p, hit.b), displacement_at(p, object_data(p.object), hit.b), 0.0);
}

float unit_float(uint bits) { return float(bits >> 8u) * (1.0 / 16777216.0); }
float random_at(uint pixel, uint sample_index, uint dimension) { return unit_float(pcg3d(uvec3(pixel, sample_index, dimension)).x); }

uint pixel_index(ivec2 px) { return uint(px.y) * uint(frame.size.x) + uint(px.x); }

// What trace_ray() of the ways of tracing answers: the first hit of origin + t direction for t in [t_min, t_max]; for any_hit,
// whether there is one. Nothing where t_max < t_min: all invocations ask, but not all have a ray.
struct TraceHit {
    uint primitive;  // kNoHit: nothing
    float t;
    vec2 b;
};
const uint kNoHit = 0xffffffffu;
const float kNoReach = -1.0;  // the t_max of no ray

#include "intersect.glsl"  // the method's own: found by the include path of its folder

// The primitive that a box, or a driver's triangle, of the tree belongs to: itself, where the method has none of its own.
#ifndef RELIEVO_OWN_BOXES
uint primitive_of_box(uint box) { return box; }
#endif
