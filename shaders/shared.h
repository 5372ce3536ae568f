// Structs and bindings that C++ and GLSL share. Scalar block layout; the sizes are asserted at the end.
// Spaces: "world" is rebased world space (world minus Scene::origin); "frame" is the triangle's own: x along the first
// edge P1 - P0, y = ng x tangent, w along the geometric normal ng, origin at P0.
#ifndef RELIEVO_SHARED_H
#define RELIEVO_SHARED_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
namespace relievo::gpu {
using glm::ivec2;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = std::uint32_t;
#define RELIEVO_CONST constexpr
#else
#define RELIEVO_CONST const
#endif

// One base triangle as rays meet it: its parallel offset prism (paper 002 section 4) and its texture footprint.
// The vertex i of the offset triangle at height w is q_i + w * shift_i in the frame's plane, with q_0 = 0.
struct Primitive {
    vec3 origin;   // P0, world
    float w_low;   // the surface of this triangle lies between w_low and w_high along ng, or over the slant, world units
    vec3 tangent;  // unit
    float w_high;
    vec3 ng;       // unit geometric normal
    float q1x;     // P1 = (q1x, 0), q1x > 0
    vec2 q2;       // P2
    vec2 shift0, shift1, shift2;  // lateral part of N_i / (N_i.ng): m_i = ng + shift_i
    vec2 tx0, tx1, tx2;  // texel coordinates uv * size - 1/2, relative to the integer `base`
    uint base;           // base texel, x in the low and y in the high 16 bits, already wrapped
    uint base_high;      // procedural heights have no period: the high 16 bits of x and y, in the same places; else 0
    uint face;           // of the object's base mesh
    uint object;
    uint flags;          // kPrimitive*
    float shell_margin;  // how far, in barycentrics, the surface may reach over the parallel prism's sides
};
RELIEVO_CONST uint kPrimitiveOpenEdge0 = 1u;  // bit i: the edge opposite vertex i belongs to this triangle alone
RELIEVO_CONST uint kPrimitiveFolded = 8u;     // the offset triangle turns over between w_low and w_high
RELIEVO_CONST uint kPrimitiveSearched = 16u;  // for methods that meet S itself: its shell folds, or stands far from the
                                              // prism. w_low and w_high are then bounds of the displacement
// The prism's ends are slanted (renderer/slant.h): w_low and w_high bound w less x times the slant's x and y times its y, in
// the frame. Two signed numbers of 13 bits, in steps; never of a folded or searched triangle.
RELIEVO_CONST uint kPrimitiveSlanted = 0xffffffc0u;  // any of these
RELIEVO_CONST int kSlantShiftX = 6, kSlantShiftY = 19;
RELIEVO_CONST uint kSlantMaskX = 0x7ffc0u;
RELIEVO_CONST float kSlantStep = 1.0f / 1024.0f;

// What only a hit needs.
struct PrimitiveNormals {
    vec3 n0, n1, n2;  // unit vertex normals, world
};

struct ObjectData {
    float amplitude;  // world units from map value 0 to 1
    float midlevel;   // [0, 1]
    ivec2 map_size;   // texels
    vec3 albedo;      // linear
    float roughness;  // [0.02, 1]
    float specular;   // reflectance at normal incidence
    float radius;     // bounding sphere of the base mesh, world units: the unit of dt
    uint clamp_wrap;  // 1: clamp, 0: repeat
    float ray_offset; // world units: secondary rays start this far along the normal
    uint albedo_map;  // 1: the albedo is that of the object's map
    int slabs_left_out;  // finest levels of the bounds about planes that are not kept (renderer/height_slabs.h)
};

// A procedural height source (geometry/procedural.glsl), one an object. Lattice coordinates are 32.32 fixed point, two's
// complement, low word first.
struct ProceduralData {
    uvec2 start_x, start_y;  // lattice coordinates of virtual texel (0, 0)
    uvec2 step_xy;           // the first lattice coordinate's change per texel up; across it stays
    uvec2 step_yx, step_yy;  // the second one's, across and up
    vec2 range;              // least and greatest height value, wherever
    vec2 uv_scale, uv_start; // uv = uv_start + (texel coordinates + 1/2) uv_scale
    uvec2 inverse;           // device address of the table that leads back, low word first: kInverseSize pairs of heights, 0
                             // to 65535, the entry's own in the low 16 bits and the next one's in the high ones
    uint seed;
    uint used;               // kHeightsOfMap: the object's heights are its map's, else they are procedural, and dbvh may walk
                             // their lattice, or the texels alone (a triangle is too thin over the lattice)
};
RELIEVO_CONST int kInverseSize = 4096;
RELIEVO_CONST uint kHeightsOfMap = 0u, kHeightsOfLattice = 1u, kHeightsOfTexels = 2u;

// One node of the program's own tree of boxes (renderer/wide_bvh.h): up to four children with their boxes. Child i spans
// origin + 2^exponent * (byte i of low, byte i of high) along each axis, and never less than what it holds. Some bound
// their children along the slab's direction too (trace/node_boxes.glsl): steps of 1/255 of what the grid of 255 steps has
// along it, from where that begins.
struct BvhNode {
    vec3 origin;     // world
    uint exponents;  // byte 0: the greatest exponent of the axes' steps, plus 127; then 4 bits an axis: how far its own lies
                     // below; then 12 bits: the slab's direction
    uvec4 child;     // kBvhLeaf | primitive, or the index of a node, or kBvhNone: those come last
    uvec3 low;       // of each axis: a byte a child, in steps from origin
    uvec3 high;
    uint slab_low, slab_high;  // along the slab's direction, likewise
};
RELIEVO_CONST uint kBvhNoSlab = 3072u;  // as a direction, and all above
RELIEVO_CONST uint kBvhLeaf = 0x80000000u;
RELIEVO_CONST uint kBvhNone = 0xffffffffu;
RELIEVO_CONST uint kBvhStack = 48u;  // nodes that wait while others are walked: the builder's promise

// A corner of micro-triangles of S (renderer/micro_mesh.h). A driver reads the positions, too.
struct MicroVertex {
    vec3 position;  // world
    vec2 b;         // barycentrics of the base triangle's vertices 1 and 2
};

struct LightData {
    vec3 position;   // sun: unit direction towards the sun; point: world
    float size;      // sun: tangent of the angular radius; point: sphere radius, world units
    vec3 radiance;   // sun: irradiance; point: radiant intensity
    uint is_point;
};
RELIEVO_CONST uint kMaxLights = 8u;

struct FrameData {
    vec3 eye;        // world
    float spare0;
    vec3 right;      // half the image's width at distance 1
    float spare1;
    vec3 up;         // half the image's height at distance 1
    float spare2;
    vec3 forward;    // unit
    float spare3;
    vec3 zenith;     // sky, linear radiance
    uint light_count;
    vec3 horizon;
    uint object_count;
    vec3 ground;
    float spare4;
    vec3 sky_up;     // unit, towards the zenith
    float spare5;
    ivec2 size;        // image, pixels
    uvec2 bvh;         // device address of the BvhNodes, low word first; 0 where another way of tracing is used
    uvec2 primitives;  // device address of the Primitives
    // Device addresses, where the method has micro-triangles: MicroVertices, and of micro-triangle i, which is box or
    // triangle i of the tree, three of their numbers (12 bytes) and the number of its Primitive (4 bytes).
    uvec2 micro_vertices, micro_corners, micro_primitives;
    vec4 parameters0, parameters1;  // of the method, in the registry's order
    LightData lights[8];
};

struct PushData {
    ivec2 offset;       // of the window, pixels
    ivec2 extent;
    uint sample_index;  // seeds the sampling; 0 for the first
    uint preview;       // 1: shadows of lights only, shown until the first real sample
    uint ray_count;     // pick: rays in the buffer
    uint first_row;     // layers: the image's row that their buffer begins with
};

struct PickRay {
    vec3 origin;
    float t_max;
    vec3 direction;  // unit
    float spare;
};

struct PickResult {
    float t;  // negative: no hit
    uint object, face;
    float b1, b2;
    vec3 normal;  // geometric, of S
};

struct AovPixel {
    float depth;  // along the unit ray; infinity where nothing is hit
    vec3 normal, shading_normal;
    vec2 uv;
    float id;  // object index + 1; 0: nothing
};

// What happened to one ray, step by step. Written only where a specialisation constant asks for it (kSpecNotes).
struct Note {
    uint kind;       // kNote*
    uint primitive;  // met
    float t;         // along the ray
    float height;    // of the ray over the base triangle, along the interpolated unit normal, world units
    vec2 texel;      // texel coordinates uv * size - 1/2, not wrapped
    float extent;    // step: texels that it may cross, 0 for a sample; cell: the ray's parameter where it leaves it
    float spare;
};
RELIEVO_CONST uint kNoteBox = 0u;   // the triangle's box was met
RELIEVO_CONST uint kNoteStep = 1u;  // the method looked at the path: a stretch of it, or a sample
RELIEVO_CONST uint kNoteCell = 2u;  // the surface over one texel cell was solved
RELIEVO_CONST uint kNoteRoot = 3u;  // a place where ray and surface meet, before the triangle and the opacity are asked
RELIEVO_CONST uint kNoteHit = 4u;   // the triangle's answer
RELIEVO_CONST uint kMaxNotes = 8192u;  // a ray; what comes after is counted, not kept

RELIEVO_CONST uint kBindTlas = 0u;
RELIEVO_CONST uint kBindFrame = 1u;
RELIEVO_CONST uint kBindPrimitives = 2u;
RELIEVO_CONST uint kBindNormals = 3u;
RELIEVO_CONST uint kBindObjects = 4u;
RELIEVO_CONST uint kBindAccumulation = 5u;  // vec4 a pixel: sum of radiance, sum of coverage
RELIEVO_CONST uint kBindCounts = 6u;        // uint a pixel: samples in the sum
RELIEVO_CONST uint kBindDisplay = 7u;       // rgba8 storage image
RELIEVO_CONST uint kBindAov = 8u;
RELIEVO_CONST uint kBindPickRays = 9u;
RELIEVO_CONST uint kBindPickResults = 10u;
RELIEVO_CONST uint kBindMaps = 11u;     // combined image samplers, one an object
RELIEVO_CONST uint kBindOpacity = 12u;  // likewise
RELIEVO_CONST uint kBindPyramids = 13u;  // min-max pyramids of the maps, where the method bounds heights
RELIEVO_CONST uint kBindRayCounts = 14u;  // uvec4 a pixel: boxes, steps, fetches, cells of the primary ray
RELIEVO_CONST uint kBindNotes = 15u;      // of one ray: their number, then the notes
RELIEVO_CONST uint kBindProcedural = 16u;  // ProceduralData, one an object
RELIEVO_CONST uint kBindAlbedo = 17u;      // combined image samplers, one an object
RELIEVO_CONST uint kBindSlabs = 18u;       // bounds of the maps about planes (renderer/height_slabs.h)
RELIEVO_CONST uint kBindCount = 19u;
RELIEVO_CONST int kPyramidLevels = 7;    // levels 1..7 of the pyramid, and of the slabs, are the image's mips 0..6

// Specialisation constants: what features.cpp derived.
RELIEVO_CONST uint kSpecObjects = 0u;   // number of objects; 1 spares the indexing of textures
RELIEVO_CONST uint kSpecShadows = 1u;
RELIEVO_CONST uint kSpecOpacity = 2u;
RELIEVO_CONST uint kSpecGloss = 3u;
RELIEVO_CONST uint kSpecSky = 4u;       // sky light with visibility rays
RELIEVO_CONST uint kSpecNotes = 5u;     // kNotesNone, kNotesCounts or kNotesLog
RELIEVO_CONST uint kSpecSearch = 6u;    // triangles flagged kPrimitiveSearched are there
RELIEVO_CONST uint kSpecProcedural = 7u;  // procedural height sources are there
RELIEVO_CONST uint kSpecAlbedo = 8u;      // albedo maps are there
RELIEVO_CONST uint kSpecSlants = 9u;      // triangles flagged kPrimitiveSlanted are there
RELIEVO_CONST uint kSpecCount = 10u;
RELIEVO_CONST uint kNotesNone = 0u, kNotesCounts = 1u, kNotesLog = 2u;

RELIEVO_CONST uint kGroupWidth = 8u;  // pixels a side of a compute workgroup

#ifdef __cplusplus
static_assert(sizeof(Primitive) == 128);
static_assert(sizeof(PrimitiveNormals) == 36);
static_assert(sizeof(ObjectData) == 56);
static_assert(sizeof(ProceduralData) == 80);
static_assert(sizeof(BvhNode) == 64);  // a cache line
static_assert(sizeof(LightData) == 32);
static_assert(sizeof(MicroVertex) == 20);
static_assert(sizeof(FrameData) == 208 + 8 * 32);
static_assert(sizeof(PushData) == 32);
static_assert(sizeof(PickRay) == 32);
static_assert(sizeof(PickResult) == 32);
static_assert(sizeof(AovPixel) == 40);
static_assert(sizeof(Note) == 32);
}  // namespace relievo::gpu
#endif

#endif
