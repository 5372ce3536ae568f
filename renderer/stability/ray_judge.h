// Compares a method's picks of single rays with the reference.
#pragma once

#include <span>
#include <vector>

#include "renderer/judge/error_units.h"
#include "renderer/judge/image_comparison.h"
#include "renderer/stability/stability_case.h"

namespace relievo::stability {

class RayJudge {
  public:
    // Keeps the surface by reference.
    RayJudge(const Case& c, const ReferenceSurface& surface, const RaySet& set);

    // Rays in the surface, on its border, along it or starting on it have several right answers. What differs
    // from the reference's by more than a hundredth of the unit is still right when a ray within a few
    // roundings of it allows it: a miss, when such a ray misses; a hit, when it lies on S and such a ray
    // comes as far. Then it counts as one at a silhouette; else as missed, invented, or off and unexplained.
    // Depth errors are told along the normal. OffPixel::x is the ray's index.
    ImageComparison compare(std::span<const PickHit> picks) const;

    const std::vector<Ray>& rays() const { return rays_; }
    int undecided() const { return undecided_; }

  private:
    struct Answer {
        bool hit = false;
        std::uint32_t object = 0;
        double t = 0;
        glm::dvec3 normal{0};
    };
    Answer answer(const glm::dvec3& origin, const glm::dvec3& direction);
    bool agrees(const Answer& answer, const PickHit& pick) const;
    // The pick lies on S, by its own barycentrics.
    bool on_surface(const Ray& ray, const PickHit& pick) const;
    bool explained(const Ray& ray, const PickHit& pick) const;
    double normal_deg(const Ray& ray, const PickHit& pick, const glm::dvec3& expected) const;

    const ReferenceSurface& surface_;
    std::vector<Ray> rays_;
    std::vector<Answer> answers_;
    std::vector<ErrorUnit> units_;
    double rounding_ = 0;  // of the coordinates that the rays meet, world units
    int undecided_ = 0;
};

}  // namespace relievo::stability
