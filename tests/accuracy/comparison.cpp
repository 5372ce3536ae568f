// See comparison.h.
#include "tests/accuracy/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

namespace relievo::test {
namespace {

using glm::dvec3;

constexpr double kJump = 0.2;  // of the amplitude
constexpr double kOff = 0.01;  // of the amplitude
constexpr int kExamples = 4;   // of every kind

ErrorRanks ranks(std::vector<double>& errors) {
    if (errors.empty()) return {};
    std::sort(errors.begin(), errors.end());
    const auto at = [&](double part) {
        return errors[static_cast<std::size_t>(part * static_cast<double>(errors.size() - 1))];
    };
    return {at(0.5), at(0.99), at(0.999), errors.back()};
}

struct Judge {
    const ReferenceImage& image;
    const Camera& camera;
    const dvec3& scene_origin;
    double jump;

    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * image.width + x); }

    // Whether the reference is torn between two pixels.
    bool torn(int x, int y, int x2, int y2) const {
        const std::size_t a = index(x, y), b = index(x2, y2);
        if ((image.object[a] == 0) != (image.object[b] == 0)) return true;
        if (image.object[a] == 0) return false;
        return leaves_plane(a, x, y, b, x2, y2) && leaves_plane(b, x2, y2, a, x, y);
    }

    // The depth of pixel b against the tangent plane of pixel a's hit.
    bool leaves_plane(std::size_t a, int x, int y, std::size_t b, int x2, int y2) const {
        const ReferenceRay ra = ray(x, y), rb = ray(x2, y2);
        const double towards = glm::dot(rb.direction, image.normal[a]);
        const double expected = glm::dot(ra.direction, image.normal[a]) * image.depth[a] / towards;
        return !(std::abs(expected - image.depth[b]) <= jump);
    }

    ReferenceRay ray(int x, int y) const {
        return reference_camera_ray(camera, scene_origin, image.width, image.height, x + 0.5, y + 0.5);
    }

    bool silhouette(int x, int y, int reach) const {
        for (int v = std::max(y - reach, 0); v <= std::min(y + reach, image.height - 1); ++v) {
            for (int u = std::max(x - reach, 0); u <= std::min(x + reach, image.width - 1); ++u) {
                if (u + 1 < image.width && u + 1 <= x + reach && torn(u, v, u + 1, v)) return true;
                if (v + 1 < image.height && v + 1 <= y + reach && torn(u, v, u, v + 1)) return true;
            }
        }
        return false;
    }
};

}  // namespace

ImageComparison compare_images(const ReferenceImage& reference, const Camera& camera,
                               const dvec3& scene_origin, double amplitude, std::span<const float> depth,
                               std::span<const float> normal, int reach) {
    const double unit = std::abs(amplitude);
    const Judge judge{reference, camera, scene_origin, kJump * unit};
    ImageComparison result;
    std::vector<double> errors, errors_away, angles;
    int examples[3] = {0, 0, 0};
    const auto example = [&](OffPixel::Kind kind, int x, int y, double a, double b) {
        if (examples[static_cast<int>(kind)]++ < kExamples) result.examples.push_back({kind, x, y, a, b});
    };
    for (int y = 0; y < reference.height; ++y) {
        for (int x = 0; x < reference.width; ++x) {
            const std::size_t i = judge.index(x, y);
            const double expected = reference.depth[i], z = static_cast<double>(depth[i]);
            const bool hit = reference.object[i] != 0, method_hit = std::isfinite(z);
            if (!hit && !method_hit) continue;
            const bool edge = judge.silhouette(x, y, reach);
            if (hit != method_hit) {
                ++(hit ? (edge ? result.silhouette_missed : result.missed)
                       : (edge ? result.silhouette_invented : result.invented));
                if (!edge)
                    example(hit ? OffPixel::Kind::missed : OffPixel::Kind::invented, x, y, expected, z);
                continue;
            }
            ++result.both;
            const double error = std::abs(z - expected) / unit;
            errors.push_back(error);
            const dvec3 n(normal[3 * i], normal[3 * i + 1], normal[3 * i + 2]);
            angles.push_back(
                glm::degrees(std::acos(std::clamp(glm::dot(n, reference.normal[i]), -1.0, 1.0))));
            if (edge) continue;
            errors_away.push_back(error);
            if (error > kOff) ++result.off, example(OffPixel::Kind::depth, x, y, expected, z);
        }
    }
    result.depth = ranks(errors);
    result.depth_away = ranks(errors_away);
    result.normal_deg = ranks(angles);
    return result;
}

std::string ImageComparison::text() const {
    char line[512];
    std::snprintf(
        line, sizeof line,
        "%d hit; away from silhouettes %d missed, %d invented, %d off; at them %d missed, %d invented; %d "
        "unexplained; "
        "depth/amplitude median %.1e p99 %.1e p99.9 %.1e, away p99 %.1e p99.9 %.1e max %.1e; normal median "
        "%.3f p99 %.2f deg",
        both, missed, invented, off, silhouette_missed, silhouette_invented, unexplained, depth.median,
        depth.p99, depth.p999, depth_away.p99, depth_away.p999, depth_away.most, normal_deg.median,
        normal_deg.p99);
    std::string result = line;
    const auto list = [&](const std::vector<OffPixel>& pixels, const char* which) {
        for (const OffPixel& pixel : pixels) {
            const char* const kinds[] = {"missed", "invented", "off"};
            std::snprintf(line, sizeof line, "\n    %s%s at (%d, %d): reference %.7g, method %.7g", which,
                          kinds[static_cast<int>(pixel.kind)], pixel.x, pixel.y, pixel.reference,
                          pixel.method);
            result += line;
        }
    };
    list(examples, "");
    list(unexplained_examples, "unexplained: ");
    return result;
}

void count_unexplained(const ReferenceSurface& surface, const ReferenceImage& reference, const Camera& camera,
                       const dvec3& scene_origin, double amplitude, std::span<const float> depth,
                       ImageComparison& result) {
    const double unit = std::abs(amplitude), infinity = std::numeric_limits<double>::infinity();
    for (int y = 0; y < reference.height; ++y) {
        for (int x = 0; x < reference.width; ++x) {
            const auto i = static_cast<std::size_t>(y * reference.width + x);
            const double z = static_cast<double>(depth[i]), expected = reference.depth[i];
            const auto agrees = [&](double other) {
                return std::isfinite(z) ? std::abs(z - other) <= kOff * unit : !std::isfinite(other);
            };
            bool explained = agrees(expected);
            for (int k = 0; k < 24 && !explained; ++k) {
                const double radius = k < 8    ? 2e-4
                                      : k < 16 ? 7e-4
                                               : 2e-3,
                             angle = k * 0.7853981633974483 + 0.3;
                const ReferenceRay ray = reference_camera_ray(
                    camera, scene_origin, reference.width, reference.height,
                    x + 0.5 + radius * std::cos(angle), y + 0.5 + radius * std::sin(angle));
                const auto hit = surface.first_hit(ray.origin, ray.direction, 0, infinity);
                explained = agrees(hit ? hit->t : infinity);
            }
            if (explained) continue;
            if (result.unexplained++ >= kExamples) continue;
            const OffPixel::Kind kind = !std::isfinite(z)          ? OffPixel::Kind::missed
                                        : !std::isfinite(expected) ? OffPixel::Kind::invented
                                                                   : OffPixel::Kind::depth;
            result.unexplained_examples.push_back({kind, x, y, expected, z});
        }
    }
}

}  // namespace relievo::test
