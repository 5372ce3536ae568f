// See quality.h.
#include "editor/session/compare/quality.h"

#include <algorithm>
#include <chrono>

#include "editor/session/compare/error_map.h"
#include "editor/session/render_output.h"
#include "renderer/stopwatch.h"

namespace relievo {
namespace {

constexpr int kBeautySamples = 2;
constexpr int kMostExamined = 50;  // wrong pixels whose neighbouring rays are asked for an excuse

ReferenceImage reference_image(const ReferenceScene& scene, int width, int height) {
    return trace_image(scene.surface(), scene.scene().camera, scene.scene().origin, width, height);
}

TraceRays rays_of(Renderer& renderer) {
    return [&renderer](std::span<const ReferenceRay> rays) {
        std::vector<Ray> asked;
        asked.reserve(rays.size());
        for (const ReferenceRay& ray : rays)
            asked.push_back({glm::vec3(ray.origin), glm::vec3(ray.direction)});
        std::vector<MethodHit> hits;
        hits.reserve(rays.size());
        for (const PickHit& hit : renderer.pick(asked))
            hits.push_back({hit.hit, hit.object, hit.face, static_cast<double>(hit.b1),
                            static_cast<double>(hit.b2), static_cast<double>(hit.distance)});
        return hits;
    };
}

RayCost mean_cost(const std::vector<float>& counts) {
    double sums[4] = {0, 0, 0, 0};
    for (std::size_t i = 0; i < counts.size(); ++i) sums[i % 4] += static_cast<double>(counts[i]);
    const double pixels = std::max(1.0, static_cast<double>(counts.size()) / 4);
    return {sums[0] / pixels, sums[1] / pixels, sums[2] / pixels, sums[3] / pixels};
}

}  // namespace

QualityJudge::QualityJudge(const ReferenceScene& scene, int width, int height)
    : scene_(scene),
      judge_(reference_image(scene, width, height), scene.scene()),
      probe_(scene.surface(), scene.scene()) {}

double QualityJudge::estimate_seconds(const ReferenceScene& scene, int width, int height) {
    constexpr int kCoarser = 8;
    const int w = std::max(1, width / kCoarser), h = std::max(1, height / kCoarser);
    Stopwatch watch;
    reference_image(scene, w, h);
    return watch.lap_ms() * 1e-3 * (static_cast<double>(width) * height) / (static_cast<double>(w) * h);
}

QualityJudge::Measured QualityJudge::measure(Renderer& renderer, ComparedPoint& point,
                                             const std::filesystem::path& picture,
                                             const std::filesystem::path& error_map_file) const {
    Measured measured;
    point.first_frame_ms = renderer.trace_layers();
    const std::vector<float> depth = renderer.read_back(Layer::depth);
    point.errors = judge_.compare(depth, renderer.read_back(Layer::normal));
    judge_.count_unexplained(scene_.surface(), depth, point.errors, kMostExamined);
    point.gap = probe_.measure(rays_of(renderer));
    point.cost = mean_cost(renderer.read_back(Layer::counts));
    render_samples(renderer, kBeautySamples);
    measured.beauty = renderer.read_back(Layer::beauty);
    write_jpeg(picture, display_picture(renderer));
    write_png(error_map_file, error_map(image().width, image().height, judge_.errors(depth)));
    measured.frame_ms = renderer.trace_layers();
    measured.frame_ms += renderer.render({0, 0, renderer.width(), renderer.height()}, Quality::preview);
    return measured;
}

}  // namespace relievo
