// See judge.h.
#include "renderer/judge/judge.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <thread>

#include "renderer/judge/silhouettes.h"

namespace relievo {
namespace {

using glm::dvec3;

constexpr double kOff = 0.01;  // of the unit
constexpr int kExamples = 4;   // of every kind

// A pixel as it goes into the sums.
struct Pixel {
    bool reference_hit, method_hit, edge;
    double depth_error, normal_deg;  // where both hit
};

// Errors of one set of pixels, before they are ranked.
struct Sums {
    PixelErrors counts;
    std::vector<double> depth, depth_away, normal;

    void add(const Pixel& pixel) {
        if (pixel.reference_hit != pixel.method_hit) {
            ++(pixel.reference_hit ? (pixel.edge ? counts.silhouette_missed : counts.missed)
                                   : (pixel.edge ? counts.silhouette_invented : counts.invented));
            return;
        }
        ++counts.both;
        depth.push_back(pixel.depth_error);
        normal.push_back(pixel.normal_deg);
        if (pixel.edge) return;
        depth_away.push_back(pixel.depth_error);
        if (pixel.depth_error > kOff) ++counts.off;
    }

    PixelErrors ranked() {
        counts.depth = rank_errors(std::move(depth));
        counts.depth_away = rank_errors(std::move(depth_away));
        counts.normal_deg = rank_errors(std::move(normal));
        return counts;
    }
};

dvec3 normal_at(std::span<const float> normal, std::size_t pixel) {
    return {static_cast<double>(normal[3 * pixel]), static_cast<double>(normal[3 * pixel + 1]),
            static_cast<double>(normal[3 * pixel + 2])};
}

bool finite(const dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// NaN counts as the worst angle.
double angle_deg(const dvec3& a, const dvec3& b) {
    const double cosine = glm::dot(a, b);
    return cosine >= -1 ? glm::degrees(std::acos(std::min(cosine, 1.0))) : 180;
}

}  // namespace

Judge::Judge(ReferenceImage image, const Camera& camera, const dvec3& scene_origin,
             std::span<const ErrorUnit> units, int reach)
    : image_(std::move(image)),
      camera_(camera),
      origin_(scene_origin),
      units_(units.begin(), units.end()),
      silhouettes_(find_silhouettes(image_, camera_, origin_, units_, reach)) {}

Judge::Judge(ReferenceImage image, const Scene& scene, int reach)
    : Judge(std::move(image), scene.camera, scene.origin, error_units(scene), reach) {}

dvec3 Judge::direction(int x, int y) const {
    return reference_camera_ray(camera_, origin_, image_.width, image_.height, x + 0.5, y + 0.5).direction;
}

ImageComparison Judge::compare(std::span<const float> depth, std::span<const float> normal) const {
    ImageComparison result;
    Sums all;
    std::array<Sums, 3> by_angle;
    int examples[3] = {0, 0, 0};
    for (int y = 0; y < image_.height; ++y) {
        for (int x = 0; x < image_.width; ++x) {
            const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                           static_cast<std::size_t>(x);
            const double expected = image_.depth[i], z = static_cast<double>(depth[i]);
            const dvec3 n = normal_at(normal, i);
            Pixel pixel{image_.object[i] != 0, std::isfinite(z), at_silhouette(i), 0, 0};
            if (pixel.method_hit ? !finite(n) : !(z > 0)) ++result.not_finite;
            if (!pixel.reference_hit && !pixel.method_hit) continue;
            if (pixel.reference_hit && pixel.method_hit) {
                pixel.depth_error = std::abs(z - expected) / units_[image_.object[i] - 1].length;
                pixel.normal_deg = angle_deg(n, image_.normal[i]);
            }
            const dvec3 facing = pixel.reference_hit ? image_.normal[i] : n;
            all.add(pixel);
            by_angle[static_cast<std::size_t>(view_angle(glm::dot(direction(x, y), facing)))].add(pixel);
            const bool both = pixel.reference_hit && pixel.method_hit;
            if (pixel.edge || (both && pixel.depth_error <= kOff)) continue;
            const OffPixel::Kind kind = both                  ? OffPixel::Kind::depth
                                        : pixel.reference_hit ? OffPixel::Kind::missed
                                                              : OffPixel::Kind::invented;
            if (examples[static_cast<int>(kind)]++ < kExamples)
                result.examples.push_back({kind, x, y, expected, z});
        }
    }
    static_cast<PixelErrors&>(result) = all.ranked();
    for (std::size_t k = 0; k < by_angle.size(); ++k) result.by_angle[k] = by_angle[k].ranked();
    return result;
}

bool Judge::agrees(std::uint32_t object, double reference, double method) const {
    if (object == 0) return !std::isfinite(method);
    return std::isfinite(method) && std::abs(method - reference) <= kOff * units_[object - 1].length;
}

bool Judge::explained(const ReferenceSurface& surface, int x, int y, double method) const {
    constexpr double kRadii[] = {2e-5, 2e-4, 7e-4, 2e-3};  // pixels
    constexpr double kUlp = 0x1p-23;                       // of a float, of its value at most
    const auto answers = [&](const dvec3& origin, const dvec3& direction) {
        const auto hit = surface.first_hit(origin, direction, 0, std::numeric_limits<double>::infinity());
        return agrees(hit ? hit->object + 1 : 0, hit ? hit->t : 0, method);
    };
    for (int k = 0; k < 32; ++k) {
        const double radius = kRadii[k / 8], angle = k * 0.7853981633974483 + 0.3;
        const ReferenceRay ray =
            reference_camera_ray(camera_, origin_, image_.width, image_.height,
                                 x + 0.5 + radius * std::cos(angle), y + 0.5 + radius * std::sin(angle));
        if (answers(ray.origin, ray.direction)) return true;
    }
    // The eye and the places met are floats: very near to the surface their rounding is more than that.
    const ReferenceRay ray =
        reference_camera_ray(camera_, origin_, image_.width, image_.height, x + 0.5, y + 0.5);
    const dvec3 eye = glm::abs(ray.origin);
    const double reach =
        std::isfinite(method)
            ? method
            : image_.depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) +
                           static_cast<std::size_t>(x)];
    const double rounding = kUlp * (std::max({eye.x, eye.y, eye.z}) + (std::isfinite(reach) ? reach : 0));
    for (int k = 0; k < 8; ++k) {
        const dvec3 corner(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
        if (answers(ray.origin + corner * rounding, ray.direction)) return true;
    }
    return false;
}

std::vector<char> Judge::find_unexplained(const ReferenceSurface& surface, std::span<const float> depth,
                                          std::span<const std::size_t> pixels) const {
    std::vector<char> unexplained(pixels.size());
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t k = next++; k < pixels.size(); k = next++) {
            const std::size_t i = pixels[k], width = static_cast<std::size_t>(image_.width);
            unexplained[k] = !explained(surface, static_cast<int>(i % width), static_cast<int>(i / width),
                                        static_cast<double>(depth[i]));
        }
    };
    std::vector<std::thread> helpers;
    if (pixels.size() > 8)
        for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers) helper.join();
    return unexplained;
}

void Judge::count_unexplained(const ReferenceSurface& surface, std::span<const float> depth,
                              ImageComparison& result, int most) const {
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < image_.depth.size(); ++i)
        if (!agrees(image_.object[i], image_.depth[i], static_cast<double>(depth[i]))) wrong.push_back(i);
    const std::size_t examined = std::min(wrong.size(), static_cast<std::size_t>(std::max(most, 1)));
    if (examined == 0) return;
    std::vector<std::size_t> pixels;
    for (std::size_t k = 0; k < examined; ++k) pixels.push_back(wrong[k * wrong.size() / examined]);
    const std::vector<char> unexplained = find_unexplained(surface, depth, pixels);
    const auto count = static_cast<std::size_t>(std::count(unexplained.begin(), unexplained.end(), 1));
    result.unexplained += static_cast<int>(count * wrong.size() / examined);
    for (std::size_t k = 0; k < examined; ++k) {
        if (!unexplained[k] || result.unexplained_examples.size() >= static_cast<std::size_t>(kExamples))
            continue;
        const std::size_t i = pixels[k], width = static_cast<std::size_t>(image_.width);
        const double z = static_cast<double>(depth[i]);
        const OffPixel::Kind kind = !std::isfinite(z)       ? OffPixel::Kind::missed
                                    : image_.object[i] == 0 ? OffPixel::Kind::invented
                                                            : OffPixel::Kind::depth;
        result.unexplained_examples.push_back(
            {kind, static_cast<int>(i % width), static_cast<int>(i / width), image_.depth[i], z});
    }
}

std::vector<Judge::PixelError> Judge::errors(std::span<const float> depth) const {
    std::vector<PixelError> result(image_.depth.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        const std::uint32_t object = image_.object[i];
        const double z = static_cast<double>(depth[i]);
        const bool hit = std::isfinite(z);
        if (object == 0) {
            if (hit) result[i].kind = PixelError::Kind::invented;
        } else if (!hit) {
            result[i].kind = PixelError::Kind::missed;
        } else {
            result[i] = {PixelError::Kind::both,
                         static_cast<float>(std::abs(z - image_.depth[i]) / units_[object - 1].length)};
        }
    }
    return result;
}

}  // namespace relievo
