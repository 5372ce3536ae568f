// See silhouettes.h.
#include "renderer/judge/silhouettes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace relievo {
namespace {

constexpr double kJump = 0.2;  // of the unit

struct Tears {
    const ReferenceImage& image;
    const Camera& camera;
    const glm::dvec3& scene_origin;
    std::span<const ErrorUnit> units;

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
               static_cast<std::size_t>(x);
    }

    bool torn(int x, int y, int x2, int y2) const {
        const std::size_t a = index(x, y), b = index(x2, y2);
        if ((image.object[a] == 0) != (image.object[b] == 0)) return true;
        if (image.object[a] == 0) return false;
        const glm::dvec3 ray_a = direction(x, y), ray_b = direction(x2, y2);
        return leaves_plane(a, ray_a, b, ray_b) && leaves_plane(b, ray_b, a, ray_a);
    }

    // The depth of pixel b against the tangent plane of pixel a's hit.
    bool leaves_plane(std::size_t a, const glm::dvec3& ray_a, std::size_t b, const glm::dvec3& ray_b) const {
        const double towards = glm::dot(ray_b, image.normal[a]);
        const double expected = glm::dot(ray_a, image.normal[a]) * image.depth[a] / towards;
        return !(std::abs(expected - image.depth[b]) <= kJump * units[image.object[a] - 1].length);
    }

    glm::dvec3 direction(int x, int y) const {
        return reference_camera_ray(camera, scene_origin, image.width, image.height, x + 0.5, y + 0.5)
            .direction;
    }
};

}  // namespace

std::vector<std::uint8_t> find_silhouettes(const ReferenceImage& image, const Camera& camera,
                                           const glm::dvec3& scene_origin, std::span<const ErrorUnit> units,
                                           int reach) {
    const Tears tears{image, camera, scene_origin, units};
    std::vector<std::uint8_t> flags(image.depth.size());
    // A tear between two pixels counts for all whose window holds both.
    const auto mark = [&](int x, int y, int x2, int y2) {
        for (int v = std::max(y2 - reach, 0); v <= std::min(y + reach, image.height - 1); ++v)
            for (int u = std::max(x2 - reach, 0); u <= std::min(x + reach, image.width - 1); ++u)
                flags[tears.index(u, v)] = 1;
    };
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (x + 1 < image.width && tears.torn(x, y, x + 1, y)) mark(x, y, x + 1, y);
            if (y + 1 < image.height && tears.torn(x, y, x, y + 1)) mark(x, y, x, y + 1);
        }
    }
    return flags;
}

}  // namespace relievo
