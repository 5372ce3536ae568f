// The brush's view of a mesh whose displacement map is being edited: DESIGN.md section 1's S over the live
// map.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "brushes/brush.h"
#include "brushes/height_map.h"
#include "brushes/surface.h"
#include "editor/session/surface/face_tree.h"
#include "editor/session/surface/owned_texels.h"
#include "editor/session/surface/texel_sampling.h"
#include "renderer/scene/mesh.h"
#include "renderer/scene/scene.h"

namespace relievo {

// Positions are the mesh's (world space minus the scene's origin). `mesh` and `map` outlive the surface and
// keep their size; the map's texels may change at any time between calls. Const functions may run on several
// threads.
class MeshSurface final : public Surface {
  public:
    // Takes amplitude, midlevel and wrap of `displacement`.
    MeshSurface(const Mesh& mesh, const Displacement& displacement, const HeightMap& map);

    SurfacePoint at(std::uint32_t face, float b1, float b2) const override;
    std::uint32_t face_count() const override;
    // Where footprints overlap, a texel stands at several points of S: the nearest one counts.
    void texels_in_ball(glm::vec3 centre, float radius, std::vector<SurfaceTexel>& out) const override;
    void precise_texels_in_ball(glm::vec3 centre, float radius,
                                std::vector<SurfaceTexel>& out) const override;
    void visit_ball(glm::vec3 centre, float radius, const TexelVisitor& visit) const override;
    void visit_ball_precisely(glm::vec3 centre, float radius, const TexelVisitor& visit) const override;
    const SeamTable& seams() const override { return seams_; }
    float amplitude() const override { return amplitude_; }
    float midlevel() const override { return midlevel_; }

    // World units from count 0 to count 65535 (any sign, finite), and the map value of [0, 1] that does not
    // displace.
    void set_displacement(double amplitude, double midlevel);

    bool owned(int x, int y) const override;

    glm::dmat4 world_from_object() const override { return world_from_object_; }
    void set_world_from_object(const glm::dmat4& transform) { world_from_object_ = transform; }

    // The point of the base mesh nearest to a place; of several as near, that of the first face.
    FacePoint nearest_on_base(glm::dvec3 place) const;
    // World units between the centres of neighbouring texels on the base mesh: the root of the mean texel's
    // area on the face, 0 where the face has no texels.
    double texel_size(std::uint32_t face) const;

    // The normals at a face's corners lie within a cone about `axis`; `spread` is its half angle's sine (1
    // from a right angle on). It bounds how far displacement moves a point sideways.
    struct NormalCone {
        glm::vec3 axis;
        float spread, cosine;
    };

  private:
    friend class BallQuery;

    glm::vec3 fallback_normal(std::uint32_t face) const;

    const Mesh& mesh_;
    const HeightMap& map_;
    MapGrid grid_;
    float amplitude_ = 0, midlevel_ = 0;
    glm::dmat4 world_from_object_{1.0};
    FaceTree tree_;
    OwnedTexels owned_;
    std::vector<NormalCone> cones_;
    SeamTable seams_;
};

}  // namespace relievo
