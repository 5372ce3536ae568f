// From pointer events to dabs: spaced by arc length on the displaced surface, whatever the frame rate.
#include "editor/session/stroke_input.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "brushes/noise.h"

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

// The longest string of a trail, and how far a stroke must have gone to have a direction, over the radius.
constexpr double kTrail = 0.5, kFirstWay = 0.25;

StrokeInput::StrokeInput(const Brush& brush, Pick pick, CameraRay camera_ray, Apply apply,
                         const StrokeSettings& settings, GoOn go_on)
    : radius_(static_cast<double>(brush.radius)),
      spacing_(radius_ *
               static_cast<double>(brush.tool == Tool::stamp ? brush.stamp_spacing : brush.spacing)),
      pick_(std::move(pick)),
      camera_ray_(std::move(camera_ray)),
      apply_(std::move(apply)),
      settings_(settings),
      grabs_(brush.tool == Tool::grab),
      stamps_(brush.tool == Tool::stamp),
      trail_(kTrail * radius_),
      go_on_(std::move(go_on)) {
    check_stroke_settings(settings);
}

void StrokeInput::begin(const PointerEvent& event) {
    start_us_ = event.time_us;
    since_dab_ = 0;
    dabs_ = 0;
    timed_dabs_ = 1;
    brush_at_ = event;
    drag_ = sent_drag_ = glm::dvec3(0);
    last_ = pick_along({event}).front();
    held_.reset();
    waiting_.reset();
    busy_ = ends_ = false;
    placed_.clear();
    next_ = 0;
    rested_until_us_ = 0;
    arrival_.reset();
    trail_.start(glm::dvec3(0));
    if (!last_->hit.hit) return;
    if (grabs_) held_ = last_;
    std::vector<Due> dabs;
    start_part(*last_, dabs);
    if (!dabs.empty()) emit(*last_, glm::dvec3(0));
}

void StrokeInput::move(const PointerEvent& event) {
    if (grabs_) return draw_held(event, false);
    rested_until_us_ = event.time_us;
    arrival_ = {pulled(event), false};
    work();
}

void StrokeInput::rest(std::uint64_t time_us) {
    rested_until_us_ = time_us;
    work();
}

void StrokeInput::end(const PointerEvent& event) {
    if (grabs_) {
        draw_held(event, true);
        ends_ = true;
    } else {
        rested_until_us_ = event.time_us;
        arrival_ = {pulled(event), true};
    }
    work();
}

void StrokeInput::work() {
    busy_ = true;
    for (bool first = true; busy_;) {
        if (next_ == placed_.size()) {
            placed_.clear();
            next_ = 0;
            busy_ = work_on();
        } else {
            if (!first && go_on_ && !go_on_()) return;
            const Placed& placed = placed_[next_++];
            emit(placed.sample, placed.direction);
            first = false;
        }
    }
    if (!std::exchange(ends_, false)) return;
    last_.reset();
    held_.reset();
}

// One step towards the next dabs; false when there are none to come.
bool StrokeInput::work_on() {
    if (place_timed()) return true;
    if (arrival_) {
        arrive(*std::exchange(arrival_, std::nullopt));
        return true;
    }
    return ends_ && place_waiting();
}

// The first dab of a stamp that has waited for a direction until now; false where none waits.
bool StrokeInput::place_waiting() {
    if (!waiting_) return false;
    place({{*std::exchange(waiting_, std::nullopt), trail_.direction()}});
    return true;
}

// The next dab of an airbrush that is due by now: one by one, for the dabs before may have moved the surface.
bool StrokeInput::place_timed() {
    if (!last_ || grabs_ || !(settings_.rate > 0)) return false;
    const double period_us = 1e6 / static_cast<double>(settings_.rate);
    const auto due = static_cast<std::uint64_t>(static_cast<double>(timed_dabs_) * period_us);
    if (start_us_ + due > rested_until_us_) return false;
    if (place_waiting()) return true;
    ++timed_dabs_;
    PointerEvent at = last_->at;
    at.time_us = start_us_ + due;
    place({{at, trail_.direction()}});
    return true;
}

void StrokeInput::arrive(const Arrival& arrival) {
    // Waiting for a whole step spares a pick for every count of a fast mouse. It depends on the events alone.
    const double way = last_ ? distance_px(last_->at, arrival.at) : 0.0;
    if (last_ && (arrival.last ? way > 0 : way >= kStepPx))
        stretch_to(arrival.at);
    else if (last_ && settings_.rate > 0 && !arrival.last)
        last_->at.pressure = arrival.at.pressure;
    ends_ = arrival.last;
}

// Where the brush comes to when the pointer goes to `event`: no nearer than the string is long.
PointerEvent StrokeInput::pulled(const PointerEvent& event) {
    const double string = static_cast<double>(settings_.lazy_px), way = distance_px(brush_at_, event);
    const PointerEvent from = brush_at_;
    brush_at_ = event;
    if (string > 0) {
        const double part = way > string ? (way - string) / way : 0.0;
        brush_at_.x_px = from.x_px + part * (event.x_px - from.x_px);
        brush_at_.y_px = from.y_px + part * (event.y_px - from.y_px);
    }
    return brush_at_;
}

// What a pressure counts.
double StrokeInput::felt(double pressure) const {
    return std::pow(std::clamp(pressure, 0.0, 1.0), static_cast<double>(settings_.pressure_curve));
}

double StrokeInput::size(double pressure) const {
    constexpr double kLeast = 0.02;
    const double much = static_cast<double>(settings_.size_by_pressure);
    return std::max(kLeast, 1.0 - much * (1.0 - felt(pressure)));
}

// The sample's place, moved within a disc about it in the picture; unmoved where that is off the surface.
PickHit StrokeInput::strayed(const Sample& sample, std::uint32_t index) const {
    const Ray beside = camera_ray_(sample.at.x_px + 1, sample.at.y_px);
    const double pixel = static_cast<double>(sample.hit.distance) *
                         static_cast<double>(glm::length(glm::normalize(beside.direction) -
                                                         glm::normalize(sample.ray.direction)));
    if (!(pixel > 0)) return sample.hit;
    const double reach = static_cast<double>(settings_.jitter) * radius_ / pixel;
    const double way = reach * std::sqrt(random_number(settings_.seed, index, 0));
    const double angle = 2 * 3.14159265358979323846 * random_number(settings_.seed, index, 1);
    PointerEvent at = sample.at;
    at.x_px += way * std::cos(angle);
    at.y_px += way * std::sin(angle);
    const PickHit hit = pick_along({at}).front().hit;
    return hit.hit ? hit : sample.hit;
}

// Where a stamp's right is to lie, unit: along the stroke if that is asked for and it has a direction, else
// along the picture's right. Turned at random about the surface's normal by the rotation's jitter.
glm::dvec3 StrokeInput::stamp_right(const Sample& sample, glm::dvec3 direction, std::uint32_t index) const {
    const double length = glm::length(direction);
    glm::dvec3 right = direction / length;
    if (!settings_.along_stroke || !(length > 1e-9 * radius_)) {
        const Ray beside = camera_ray_(sample.at.x_px + 1, sample.at.y_px);
        const glm::dvec3 across =
            glm::normalize(glm::dvec3(beside.direction)) - glm::normalize(glm::dvec3(sample.ray.direction));
        if (!(glm::length(across) > 0)) return glm::dvec3(0);
        right = glm::normalize(across);
    }
    const glm::dvec3 n(sample.hit.normal);
    if (!(settings_.rotation_jitter > 0) || !(std::abs(glm::length(n) - 1) < 0.01)) return right;
    const double most = static_cast<double>(settings_.rotation_jitter) * (3.14159265358979323846 / 180);
    const double angle = most * (2 * random_number(settings_.seed, index, 2) - 1);
    return right * std::cos(angle) + glm::cross(n, right) * std::sin(angle) +
           n * (glm::dot(n, right) * (1 - std::cos(angle)));
}

void StrokeInput::emit(const Sample& sample, glm::dvec3 direction) {
    const std::uint32_t index = dabs_++;
    const double much = static_cast<double>(settings_.strength_by_pressure);
    const double pressure = felt(sample.at.pressure);
    const double strength = 1.0 - much * (1.0 - pressure);
    const PickHit hit = settings_.jitter > 0 && !grabs_ ? strayed(sample, index) : sample.hit;
    Dab dab = quantised_dab(hit, sample.at.time_us - start_us_, much == 1.0 ? pressure : strength);
    dab.size = std::max(1u, quantise(size(sample.at.pressure), Dab::kSizeOne));
    const glm::dvec3 hand = stamps_ ? stamp_right(sample, direction, index) : drag_ / radius_;
    for (int k = 0; k < 3; ++k) {
        const double units = hand[k] * Dab::kDragOne;
        constexpr double kMost = Dab::kLargestDrag;
        dab.drag[static_cast<std::size_t>(k)] =
            std::isfinite(units) ? static_cast<std::int32_t>(std::llround(std::clamp(units, -kMost, kMost)))
                                 : 0;
    }
    apply_(dab);
}

void StrokeInput::draw_held(const PointerEvent& event, bool last) {
    if (!held_) return;
    // A pen that is lifted lets go; what it has drawn stays.
    held_->at.pressure = std::max(held_->at.pressure, event.pressure);
    // The plane through the held point across the ray that took hold.
    const glm::dvec3 across = glm::normalize(glm::dvec3(held_->ray.direction));
    const Ray ray = camera_ray_(event.x_px, event.y_px);
    const glm::dvec3 from(ray.origin), along(ray.direction), point(held_->hit.position);
    const double slope = glm::dot(along, across);
    if (!(slope > 1e-6 * glm::length(along))) return;  // beside or behind the eye
    drag_ = from + along * (glm::dot(point - from, across) / slope) - point;
    if (glm::length(drag_ - sent_drag_) < (last ? 1e-9 * radius_ : spacing_)) return;
    sent_drag_ = drag_;
    Sample sample = *held_;
    sample.at = event;
    sample.at.pressure = held_->at.pressure;
    sample.at.time_us = std::max(event.time_us, start_us_);
    emit(sample, glm::dvec3(0));
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
    std::vector<Due> dabs;
    if (settings_.rate > 0) {
        last_ = pick_along({event}).front();
        follow(*last_, dabs);
        return place(dabs);
    }
    for (const Sample& next : pick_along(points)) walk(next, dabs);
    place(dabs);
}

// The trail goes on to the next sample; a first dab that has waited for a direction is due as soon as there
// is one, at the latest where the second one is.
void StrokeInput::follow(const Sample& next, std::vector<Due>& dabs) {
    if (!next.hit.hit) return;
    trail_.go_to(glm::dvec3(next.hit.position));
    if (waiting_ && trail_.stretched() >= std::min(kFirstWay * radius_, spacing_))
        dabs.push_back({*std::exchange(waiting_, std::nullopt), trail_.direction()});
}

// Goes on from the last sample to the next, and notes where dabs fall.
void StrokeInput::start_part(const Sample& first, std::vector<Due>& dabs) {
    if (waiting_) dabs.push_back({*std::exchange(waiting_, std::nullopt), trail_.direction()});
    trail_.start(glm::dvec3(first.hit.position));
    if (stamps_ && settings_.along_stroke)
        waiting_ = first.at;
    else
        dabs.push_back({first.at, glm::dvec3(0)});
}

void StrokeInput::walk(const Sample& next, std::vector<Due>& dabs) {
    const Sample last = std::exchange(*last_, next);
    if (!next.hit.hit) return;
    const double length = static_cast<double>(glm::length(next.hit.position - last.hit.position));
    const double across = static_cast<double>(next.hit.distance) *
                          static_cast<double>(glm::length(glm::normalize(next.ray.direction) -
                                                          glm::normalize(last.ray.direction)));
    if (!last.hit.hit || (length > kSteepest * across && length > radius_)) {
        since_dab_ = 0;
        return start_part(next, dabs);
    }
    follow(next, dabs);
    if (length == 0) return;
    const double spacing = std::max(spacing_ * size(next.at.pressure), length / kDabsPerStep);
    double walked = std::max(0.0, spacing - since_dab_);  // along this step, to the next dab
    for (; walked <= length; walked += spacing) {
        dabs.push_back({between(last.at, next.at, std::max(0.0, walked) / length), trail_.direction()});
    }
    since_dab_ = length - (walked - spacing);
}

// All are looked for on the surface as it is before the first of them.
void StrokeInput::place(const std::vector<Due>& dabs) {
    if (dabs.empty()) return;
    std::vector<PointerEvent> points;
    for (const Due& due : dabs) points.push_back(due.at);
    const std::vector<Sample> samples = pick_along(points);
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (samples[i].hit.hit) placed_.push_back({samples[i], dabs[i].direction});
}

}  // namespace relievo
