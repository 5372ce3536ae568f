// Where the copies of a dab lie that a brush's symmetry makes.
#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <unordered_map>
#include <vector>

#include "brushes/brush.h"
#include "editor/session/surface/mesh_surface.h"

namespace relievo {

class SymmetricDabs {
  public:
    // `copies`: of symmetry_copies, the identity first. Both outlive this.
    SymmetricDabs(const Mesh& mesh, const MeshSurface& surface, std::vector<glm::dmat4> copies);

    // One place for every copy but the hand's own. Where the mesh is symmetric, the mirrored face with the
    // mirrored barycentrics, exactly; elsewhere the point of the base mesh nearest to the copy's.
    std::vector<FacePoint> copies_of(const FacePoint& point) const;

  private:
    static constexpr std::uint32_t kNone = ~0u;

    void match_positions(const glm::dmat4& copy, std::vector<std::uint32_t>& matched) const;

    const Mesh& mesh_;
    const MeshSurface& surface_;
    std::vector<glm::dmat4> copies_;
    std::vector<std::vector<std::uint32_t>> matched_;  // of each copy: each position's image, or kNone
    std::unordered_multimap<std::uint64_t, std::uint32_t> faces_;  // by their positions' hash
};

}  // namespace relievo
