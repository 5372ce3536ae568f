// The double-precision reference: the first hit of a ray with the canonical surface of DESIGN.md section 1,
//   S(b) = P(b) + D(uv(b)) N(b)/|N(b)|,   D = amplitude (map(uv) - midlevel),
// found on the CPU by subdivision with conservative bounds, so that it cannot miss: no step, no sampling. It
// is the judge of every method, so it shares no code with them (but
// for what procedural heights are, shaders/geometry/procedural.glsl in double).
//
// What it answers, exactly:
//  - S is two-sided and ends at the mesh's open borders; triangles are closed, so a ray through an edge or a
//  vertex
//    hits. Folded shells (several barycentrics for one point) and several hits on a triangle are all found.
//  - A ray that touches S within rounding (some 1e-14 of the coordinates met) counts as a hit; a ray that
//  lies in S
//    hits where it enters S, or at t_min.
//  - Faces without area (has_no_area) are left out, as the renderer does.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "renderer/scene/scene.h"

namespace relievo {

// Row-major texels, row 0 at v = 0.
template <typename Texel>
struct ReferenceTexels {
    int width = 0, height = 0;
    const Texel* texels = nullptr;
};

// An object as the reference reads it. Everything pointed to outlives the ReferenceSurface, unchanged.
struct ReferenceObject {
    const Mesh* mesh = nullptr;
    double amplitude = 0, midlevel = 0.5;  // as in Displacement
    Wrap wrap = Wrap::repeat;
    ReferenceTexels<std::uint16_t> heights;  // or the exemplar of procedural ones
    ReferenceTexels<std::uint8_t>
        opacity;  // no texels: opaque; bilinear, wraps as the heights; under 127.5 is a hole
    std::optional<Procedural> procedural = {};  // the heights are not the texels, but made of them
};

// The scene's object with its map (and opacity map, if it has one).
ReferenceObject reference_object(const SceneObject& object, const ReferenceTexels<std::uint16_t>& heights,
                                 const ReferenceTexels<std::uint8_t>& opacity = {});

struct ReferenceHit {
    std::uint32_t object = 0, face = 0;
    double b1 = 0, b2 = 0;   // barycentrics of vertices 1 and 2, in the closed triangle
    double t = 0;            // in units of the ray's direction
    glm::dvec3 position{0};  // S(b1, b2), rebased space
    // cross(dS/db1, dS/db2), unit: on the side of N(b) unless the shell is folded there. On a border between
    // texel cells it is that of either cell.
    glm::dvec3 normal{0};
};

struct ReferenceAnswer {
    std::optional<ReferenceHit> hit;
    bool undecided =
        false;  // the limit of nodes was met: `hit` is the first of those found, not known to be first
    std::uint64_t nodes = 0;  // parts of the surface that were examined
};

// S at a place of a face.
struct ReferencePoint {
    glm::dvec3 position{0}, normal{0};  // as in ReferenceHit
    double displacement = 0;            // D, world units
    glm::dvec2 uv{0};
};

struct ReferenceImage {
    int width = 0, height = 0;       // row 0 at the top
    std::vector<double> depth;       // along the unit ray from the eye; infinity where nothing is hit
    std::vector<glm::dvec3> normal;  // of S; 0 where nothing is hit
    std::vector<glm::dvec2> uv;      // 0 where nothing is hit
    std::vector<std::uint32_t> object, face;  // object + 1, 0 where nothing is hit; face of the object's mesh
    std::uint64_t undecided = 0;              // pixels whose ray met the limit of nodes
};

class ReferenceSurface {
  public:
    static constexpr std::uint64_t kStandardNodeLimit = 1u
                                                        << 20;  // a ray; an ordinary one takes some hundred

    // Copies the geometry in double and makes a min-max pyramid of every map. Throws std::invalid_argument on
    // an empty map, or texture coordinates beyond 2^50 texels (2^22 of procedural heights).
    explicit ReferenceSurface(std::span<const ReferenceObject> objects,
                              std::uint64_t node_limit = kStandardNodeLimit);
    ~ReferenceSurface();
    ReferenceSurface(ReferenceSurface&&) noexcept;
    ReferenceSurface& operator=(ReferenceSurface&&) noexcept;

    // The hit with the least t in [t_min, t_max]. Rebased space; the direction need not be unit. Throws
    // std::invalid_argument when the ray is not finite or has no direction. Any number of threads may ask at
    // once.
    ReferenceAnswer trace(const glm::dvec3& origin, const glm::dvec3& direction, double t_min,
                          double t_max) const;
    std::optional<ReferenceHit> first_hit(const glm::dvec3& origin, const glm::dvec3& direction, double t_min,
                                          double t_max) const {
        return trace(origin, direction, t_min, t_max).hit;
    }

    // Requires an object and a face that exist.
    ReferencePoint evaluate(std::uint32_t object, std::uint32_t face, double b1, double b2) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

struct ReferenceRay {
    glm::dvec3 origin, direction;  // rebased space; unit
};

// The ray through a pixel position (0..width, 0..height; centres at .5, row 0 at the top), the renderer's
// camera in double. `scene_origin` is Scene::origin.
ReferenceRay reference_camera_ray(const Camera& camera, const glm::dvec3& scene_origin, int width, int height,
                                  double x_px, double y_px);

// First hits through the centres of all pixels, rows shared among `threads` (0: one a core). `progress` is
// called with the number of finished rows, from any thread, one at a time.
ReferenceImage trace_image(const ReferenceSurface& surface, const Camera& camera,
                           const glm::dvec3& scene_origin, int width, int height, int threads = 0,
                           const std::function<void(int)>& progress = {});

}  // namespace relievo
