// The copies of a stroke that a brush's symmetry makes, and the surface as each copy's own hand sees it.
//
// A copy is worked out in the frame of the hand: places and directions of the surface are turned or mirrored
// back, so that a tool does there what it does under the hand, with the same arithmetic. On a mesh and a map
// that are symmetric, both sides of a mirror plane therefore come out equal to the last count.
#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "brushes/brush.h"
#include "brushes/surface.h"

namespace relievo {

// The isometries from the hand to each copy in world space: the identity first, then mirrors and turns about
// the object's own axes through its own origin, none twice. Throws std::invalid_argument where
// `world_from_object` is sheared so that a mirror image of the object would have another shape.
std::vector<glm::dmat4> symmetry_copies(const Brush& brush, const glm::dmat4& world_from_object);

class TurnedSurface final : public Surface {
  public:
    TurnedSurface(const Surface& surface, const glm::dmat4& world_from_hand)
        : surface_(surface), world_from_hand_(world_from_hand), hand_from_world_(inverse(world_from_hand)) {}

    SurfacePoint at(std::uint32_t face, float b1, float b2) const override;
    std::uint32_t face_count() const override { return surface_.face_count(); }
    void texels_in_ball(glm::vec3 centre, float radius, std::vector<SurfaceTexel>& out) const override;
    void visit_ball(glm::vec3 centre, float radius, const TexelVisitor& visit) const override;
    bool owned(int x, int y) const override { return surface_.owned(x, y); }
    const SeamTable& seams() const override { return surface_.seams(); }
    float amplitude() const override { return surface_.amplitude(); }
    float midlevel() const override { return surface_.midlevel(); }

  private:
    glm::vec3 in_world(glm::vec3 place) const { return glm::vec3(world_from_hand_ * glm::dvec4(place, 1.0)); }
    void turn(std::span<SurfaceTexel> texels, glm::vec3 centre) const;  // from the world to the hand

    const Surface& surface_;
    glm::dmat4 world_from_hand_, hand_from_world_;
};

}  // namespace relievo
