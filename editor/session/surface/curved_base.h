// How far a base triangle bulges where it is curved as its corners' normals tell, which is how shading shows
// it: Phong tessellation (Boubekeur and Alexa 2008), measured along the normal. Deviation: a shape factor of
// 1/2, at which the curve leaves each corner along its tangent plane (and follows a circle), in the place of
// their 3/4.
#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace relievo {

// b0 b1 c2 + b1 b2 c0 + b2 b0 c1, in the unit of the positions; c[i] belongs to the edge across from corner
// i, so that two triangles bulge by the same along the edge that they share.
struct Bulge {
    glm::dvec3 c;

    // `normals` are unit vectors, or 0.
    Bulge(const std::array<glm::dvec3, 3>& positions, const std::array<glm::dvec3, 3>& normals)
        : c(edge(positions, normals, 1, 2), edge(positions, normals, 2, 0), edge(positions, normals, 0, 1)) {}

    // At barycentrics b.
    double at(const glm::dvec3& b) const { return b.y * b.z * c.x + b.z * b.x * c.y + b.x * b.y * c.z; }

    // at(s u + t v) = s^2 at(u) + s t mixed(u, v) + t^2 at(v)
    double mixed(const glm::dvec3& u, const glm::dvec3& v) const { return at(u + v) - at(u) - at(v); }

  private:
    static double edge(const std::array<glm::dvec3, 3>& p, const std::array<glm::dvec3, 3>& n, std::size_t i,
                       std::size_t j) {
        return 0.5 * glm::dot(p[j] - p[i], n[j] - n[i]);
    }
};

}  // namespace relievo
