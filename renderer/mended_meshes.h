// The scene's meshes as a method traces them: as they are, or with sharp creases mended (paper 002, section 5.4).
#pragma once

#include <vector>

#include "renderer/scene/creases.h"
#include "renderer/scene/scene.h"

namespace relievo {

struct FacePoint {
    std::uint32_t face;
    float b1, b2;
};

class MendedMeshes {
  public:
    // `scene` outlives it.
    explicit MendedMeshes(const Scene& scene);

    bool any() const;  // some mesh has a crease below the threshold
    std::vector<Mesh> traced(bool mended) const;

    // A point of a mended face in the base mesh's own faces and barycentrics (the nearest ones for the strip itself).
    FacePoint on_base(std::size_t object, const FacePoint& traced) const;

  private:
    const Scene* scene_;
    std::vector<MendedMesh> mended_;
};

}  // namespace relievo
