// The ray as the z axis: where points lie around it, and whether a thickened convex hull can hold it.
#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace relievo::reference {

class RayFrame {
  public:
    // `unit` is a unit vector.
    RayFrame(const glm::dvec3& origin, const glm::dvec3& unit);

    // x and y across the ray, z along it from the origin.
    glm::dvec3 local(const glm::dvec3& point) const { return turn(point - origin_); }
    glm::dvec3 turn(const glm::dvec3& vector) const;
    const glm::dvec3& direction() const { return z_; }

  private:
    glm::dvec3 origin_, x_, y_, z_;
};

// False when the z axis stays farther than `radius` from the hull of the points: some line across separates
// them. Errs to true only. Local points, at least one.
bool axis_meets_hull(std::span<const glm::dvec3> points, double radius);

}  // namespace relievo::reference
