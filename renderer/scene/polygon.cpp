// Ear clipping (Meisters 1975) in the plane that Newell's normal gives. A polygon that offers no ear (it
// crosses itself or has no area) is cut all the same: every input gives size - 2 triangles.
#include <glm/geometric.hpp>
#include <numeric>

#include "renderer/scene/mesh_soup.h"

namespace relievo {

namespace {

constexpr std::size_t kMostCornersForEars = 256;

glm::dvec3 newell_normal(std::span<const glm::dvec3> polygon) {
    glm::dvec3 sum(0);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        sum += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    }
    return sum;
}

bool is_ear(std::span<const glm::dvec3> polygon, std::span<const std::uint32_t> left, std::size_t at,
            const glm::dvec3& normal) {
    const std::size_t n = left.size();
    const glm::dvec3 a = polygon[left[(at + n - 1) % n]], b = polygon[left[at]],
                     c = polygon[left[(at + 1) % n]];
    const auto side = [&](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
        return glm::dot(glm::cross(q - p, r - p), normal);
    };
    if (side(a, b, c) <= 0) return false;
    for (std::size_t i = 2; i + 1 < n; ++i) {
        const glm::dvec3& p = polygon[left[(at + i) % n]];
        if (side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0) return false;
    }
    return true;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const glm::dvec3> polygon) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> left(polygon.size());
    std::iota(left.begin(), left.end(), 0u);
    const glm::dvec3 normal = newell_normal(polygon);
    while (left.size() >= 3) {
        std::size_t ear = 1;
        if (left.size() > 3 && polygon.size() <= kMostCornersForEars) {
            while (ear <= left.size() && !is_ear(polygon, left, ear % left.size(), normal)) ++ear;
            ear = ear > left.size() ? 1 : ear % left.size();
        }
        const std::size_t n = left.size();
        triangles.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return triangles;
}

}  // namespace relievo
