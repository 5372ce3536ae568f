// Whole images by the reference, rows shared among threads.
#include <atomic>
#include <cmath>
#include <exception>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <mutex>
#include <thread>

#include "renderer/reference/reference.h"

namespace relievo {

using glm::dvec3;

ReferenceRay reference_camera_ray(const Camera& camera, const dvec3& scene_origin, int width, int height,
                                  double x_px, double y_px) {
    const dvec3 forward = glm::normalize(camera.look_at - camera.eye);
    dvec3 right = glm::cross(forward, camera.up);
    // Looking straight along `up`: any other axis serves, the same as in renderer/view.cpp.
    if (glm::length(right) < 1e-9 * glm::length(camera.up))
        right = glm::cross(forward, std::abs(forward.x) < 0.9 ? dvec3(1, 0, 0) : dvec3(0, 0, 1));
    right = glm::normalize(right);
    const dvec3 up = glm::cross(right, forward);
    const double half_height = std::tan(glm::radians(camera.fov_deg) / 2);
    const double x = x_px / width * 2 - 1, y = y_px / height * 2 - 1;
    return {camera.eye - scene_origin,
            glm::normalize(forward + right * (x * half_height * width / height) - up * (y * half_height))};
}

namespace {

struct Rows {
    const ReferenceSurface& surface;
    const Camera& camera;
    const dvec3& scene_origin;
    ReferenceImage& image;
    std::atomic<int> next{0};
    std::atomic<std::uint64_t> undecided{0};
    std::mutex mutex{};  // of the two below
    int finished = 0;
    std::exception_ptr failure{};

    void trace_row(int y) {
        for (int x = 0; x < image.width; ++x) {
            const ReferenceRay ray =
                reference_camera_ray(camera, scene_origin, image.width, image.height, x + 0.5, y + 0.5);
            const ReferenceAnswer answer =
                surface.trace(ray.origin, ray.direction, 0, std::numeric_limits<double>::max());
            if (answer.undecided) ++undecided;
            if (!answer.hit) continue;
            const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                               static_cast<std::size_t>(x);
            const ReferenceHit& hit = *answer.hit;
            image.depth[pixel] = hit.t;
            image.normal[pixel] = hit.normal;
            image.uv[pixel] = surface.evaluate(hit.object, hit.face, hit.b1, hit.b2).uv;
            image.object[pixel] = hit.object + 1;
            image.face[pixel] = hit.face;
        }
    }

    void work(const std::function<void(int)>& progress) {
        try {
            for (int y = next++; y < image.height; y = next++) {
                trace_row(y);
                const std::lock_guard lock(mutex);
                ++finished;
                if (progress) progress(finished);
            }
        } catch (...) {
            const std::lock_guard lock(mutex);
            failure = std::current_exception();
            next = image.height;
        }
    }
};

}  // namespace

ReferenceImage trace_image(const ReferenceSurface& surface, const Camera& camera, const dvec3& scene_origin,
                           int width, int height, int threads, const std::function<void(int)>& progress) {
    ReferenceImage image;
    image.width = width;
    image.height = height;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    image.depth.assign(pixels, std::numeric_limits<double>::infinity());
    image.normal.assign(pixels, dvec3(0));
    image.uv.assign(pixels, glm::dvec2(0));
    image.object.assign(pixels, 0);
    image.face.assign(pixels, 0);
    Rows rows{surface, camera, scene_origin, image};
    const unsigned wanted =
        threads > 0 ? static_cast<unsigned>(threads) : std::thread::hardware_concurrency();
    std::vector<std::thread> helpers;
    for (unsigned i = 1; i < wanted; ++i) helpers.emplace_back([&] { rows.work(progress); });
    rows.work(progress);
    for (std::thread& helper : helpers) helper.join();
    if (rows.failure) std::rethrow_exception(rows.failure);
    image.undecided = rows.undecided;
    return image;
}

}  // namespace relievo
