// A stamp's image as one dab lays it on the surface: in the plane across the base normal at the dab's centre,
// its longer side as wide as the brush.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>

#include "brushes/alpha.h"
#include "brushes/surface.h"
#include "brushes/tangent_frame.h"

namespace relievo {

class PressedImage {
  public:
    // `right`: where the image's right is to lie, world space, any length; zero: anywhere. `degrees`: turned
    // about the normal. `texels`: how many the ball of `radius` (world units) holds; the image is filtered as
    // wide as one of them. The image outlives this.
    PressedImage(const Alpha& alpha, const SurfacePoint& centre, float radius, glm::vec3 right, float degrees,
                 std::size_t texels)
        : alpha_(alpha),
          centre_(centre.position),
          frame_(turned(tangent_frame(centre.base_normal, right), double{degrees})),
          unit_(1.0 / double{radius}),
          footprint_(std::sqrt(3.14159265358979323846 / static_cast<double>(texels > 0 ? texels : 1))) {}

    // The image's value there; 0 beyond its border, and where the surface faces away.
    float at(const SurfaceTexel& texel) const {
        if (!(glm::dot(glm::dvec3(texel.normal), frame_.normal) > 0.0)) return 0.0f;
        const glm::dvec3 offset = unit_ * (glm::dvec3(texel.position) - centre_);
        return alpha_.at(glm::dot(offset, frame_.right), glm::dot(offset, frame_.up), footprint_);
    }

  private:
    const Alpha& alpha_;
    glm::dvec3 centre_;
    TangentFrame frame_;
    double unit_, footprint_;  // 1 / world units; of the radius
};

}  // namespace relievo
