// A whole scene as the double-precision reference meets it: every object's mesh, map and holes, read from
// their files. No Vulkan device is needed.
#pragma once

#include <memory>

#include "brushes/height_map.h"
#include "renderer/reference/reference.h"
#include "renderer/scene/scene.h"

namespace relievo {

class ReferenceScene {
  public:
    // Throws std::invalid_argument that names the map that cannot be read.
    explicit ReferenceScene(Scene scene);
    ~ReferenceScene();
    ReferenceScene(ReferenceScene&&) noexcept;
    ReferenceScene& operator=(ReferenceScene&&) noexcept;

    const Scene& scene() const;
    const ReferenceSurface& surface() const;
    const HeightMap& map(std::size_t object) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace relievo
