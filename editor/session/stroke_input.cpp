// From pointer events to dabs: spaced by arc length on the displaced surface, whatever the frame rate.
#include "editor/session/stroke_input.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace relievo {
namespace {

constexpr double kStepPx = 2.0;  // between the points whose picks measure the arc length

// Between two picks the surface may run away from the eye; beyond this many times their distance across the
// view it is taken for another part of the surface behind a silhouette, and the stroke starts anew there.
constexpr double kSteepest = 16.0;

// A brush far smaller than a pixel would make thousands of dabs between two picks.
constexpr double kDabsPerStep = 8.0;

double distance_px(const PointerEvent& a, const PointerEvent& b) {
    return std::hypot(b.x_px - a.x_px, b.y_px - a.y_px);
}

PointerEvent between(const PointerEvent& a, const PointerEvent& b, double t) {
    const auto elapsed = static_cast<double>(b.time_us - a.time_us);
    return {a.time_us + static_cast<std::uint64_t>(std::llround(t * elapsed)), a.x_px + t * (b.x_px - a.x_px),
            a.y_px + t * (b.y_px - a.y_px), a.pressure + t * (b.pressure - a.pressure)};
}

std::uint32_t quantise(double value, double one) {
    return static_cast<std::uint32_t>(std::llround(std::clamp(value, 0.0, 1.0) * one));
}

}  // namespace

Dab quantised_dab(const PickHit& hit, std::uint64_t time_us, double pressure) {
    Dab dab;
    dab.time_us = static_cast<std::uint32_t>(std::min<std::uint64_t>(time_us, UINT32_MAX));
    dab.face = hit.face;
    dab.b1 = quantise(static_cast<double>(hit.b1), Dab::kBarycentricOne);
    dab.b2 =
        std::min(quantise(static_cast<double>(hit.b2), Dab::kBarycentricOne), Dab::kBarycentricOne - dab.b1);
    dab.pressure = quantise(pressure, Dab::kPressureOne);
    return dab;
}

StrokeInput::StrokeInput(const Brush& brush, Pick pick, CameraRay camera_ray, Apply apply)
    : radius_(static_cast<double>(brush.radius)),
      spacing_(radius_ * static_cast<double>(brush.spacing)),
      pick_(std::move(pick)),
      camera_ray_(std::move(camera_ray)),
      apply_(std::move(apply)) {}

void StrokeInput::begin(const PointerEvent& event) {
    start_us_ = event.time_us;
    since_dab_ = 0;
    last_ = pick_along({event}).front();
    if (last_->hit.hit) apply_(quantised_dab(last_->hit, 0, event.pressure));
}

void StrokeInput::move(const PointerEvent& event) {
    // Waiting for a whole step spares a pick for every count of a fast mouse. It depends on the events alone.
    if (last_ && distance_px(last_->at, event) >= kStepPx) stretch_to(event);
}

void StrokeInput::end(const PointerEvent& event) {
    if (last_ && distance_px(last_->at, event) > 0) stretch_to(event);
    last_.reset();
}

std::vector<StrokeInput::Sample> StrokeInput::pick_along(const std::vector<PointerEvent>& points) const {
    std::vector<Ray> rays;
    for (const PointerEvent& point : points) rays.push_back(camera_ray_(point.x_px, point.y_px));
    const std::vector<PickHit> hits = pick_(rays);
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < points.size(); ++i) {
        samples.push_back({points[i], hits[i], rays[i]});
        samples.back().hit.hit = hits[i].hit && hits[i].object == 0;
    }
    return samples;
}

void StrokeInput::stretch_to(const PointerEvent& to) {
    const PointerEvent from = last_->at;
    PointerEvent event = to;
    event.time_us = std::max(from.time_us, to.time_us);  // a clock that steps back must not wrap around
    const int steps = std::max(1, static_cast<int>(std::ceil(distance_px(from, event) / kStepPx)));
    std::vector<PointerEvent> points;
    for (int i = 1; i <= steps; ++i) points.push_back(between(from, event, static_cast<double>(i) / steps));
    std::vector<PointerEvent> dabs;
    for (const Sample& next : pick_along(points)) walk(next, dabs);
    if (!dabs.empty()) place(dabs);
}

// Goes on from the last sample to the next, and notes where dabs fall.
void StrokeInput::walk(const Sample& next, std::vector<PointerEvent>& dabs) {
    const Sample last = std::exchange(*last_, next);
    if (!next.hit.hit) return;
    const double length = static_cast<double>(glm::length(next.hit.position - last.hit.position));
    const double across = static_cast<double>(next.hit.distance) *
                          static_cast<double>(glm::length(glm::normalize(next.ray.direction) -
                                                          glm::normalize(last.ray.direction)));
    if (!last.hit.hit || (length > kSteepest * across && length > radius_)) {
        since_dab_ = 0;
        dabs.push_back(next.at);
        return;
    }
    if (length == 0) return;
    const double spacing = std::max(spacing_, length / kDabsPerStep);
    double walked = spacing - since_dab_;  // along this step, to the next dab
    for (; walked <= length; walked += spacing) {
        dabs.push_back(between(last.at, next.at, std::max(0.0, walked) / length));
    }
    since_dab_ = length - (walked - spacing);
}

void StrokeInput::place(const std::vector<PointerEvent>& points) {
    for (const Sample& sample : pick_along(points))
        if (sample.hit.hit)
            apply_(quantised_dab(sample.hit, sample.at.time_us - start_us_, sample.at.pressure));
}

}  // namespace relievo
