// See answers.h.
#include "editor/session/compare/answers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace relievo {
namespace {

constexpr double kKept = 1e-3;      // the depth error asked for, over the unit
constexpr double kFewWrong = 1e-3;  // share of the pixels
constexpr double kEqual = 0.99;     // an error above this part of another is no better

double at(const std::vector<double>& sorted, double part) {
    const double place = part * static_cast<double>(sorted.size() - 1);
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, sorted.size() - 1);
    return std::lerp(sorted[low], sorted[high], place - static_cast<double>(low));
}

Rival rival_of(const ComparedPoint* subject, const ComparedPoint* other) {
    if (!other) return {};
    return {other->label, time_ratio(subject->primary, other->primary),
            time_ratio(subject->preview, other->preview)};
}

// Points stand coarse first within their method.
SpeedAnswer answer(const ComparedPoint& subject, const std::string& method,
                   const std::vector<ComparedPoint>& points) {
    const ComparedPoint *at_p999 = nullptr, *at_p99 = nullptr;
    for (const ComparedPoint& point : points) {
        if (point.method != method) continue;
        if (!at_p999 && point.errors.depth.p999 <= kKept) at_p999 = &point;
        if (!at_p99 && point.errors.depth.p99 <= kKept) at_p99 = &point;
    }
    return {subject.label, method, rival_of(&subject, at_p999), rival_of(&subject, at_p99),
            rival_of(&subject, best_point(points, method))};
}

}  // namespace

Spread spread_of(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    return {at(values, 0.5), at(values, 0.1), at(values, 0.9)};
}

std::size_t most_exact_point(const std::vector<ComparedPoint>& points) {
    const auto key = [](const ComparedPoint& p) {
        const double pixels = std::max(1, p.errors.both + p.wrong());
        return std::tuple(std::floor((p.wrong() + p.errors.off) / (kFewWrong * pixels)), p.errors.depth.p999,
                          p.errors.depth.p99);
    };
    const auto best = std::min_element(points.begin(), points.end(),
                                       [&](const auto& a, const auto& b) { return key(a) < key(b); });
    return static_cast<std::size_t>(best - points.begin());
}

const ComparedPoint* best_point(const std::vector<ComparedPoint>& points, const std::string& method) {
    double least = std::numeric_limits<double>::infinity();
    for (const ComparedPoint& point : points)
        if (point.method == method) least = std::min(least, point.errors.depth.p999);
    for (const ComparedPoint& point : points)
        if (point.method == method && kEqual * point.errors.depth.p999 <= least) return &point;
    return nullptr;
}

double time_ratio(const RoundTimes& a, const RoundTimes& b) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(a.wall.size(), b.wall.size()); ++i)
        if (b.wall[i] > 0) ratios.push_back(a.wall[i] / b.wall[i]);
    return spread_of(ratios).median;
}

void answer_speed(ComparedScene& scene) {
    scene.answers.clear();
    if (scene.points.empty()) return;
    const ComparedPoint& subject = scene.points.front();
    std::vector<std::string> seen{subject.method};
    for (const ComparedPoint& point : scene.points) {
        if (std::find(seen.begin(), seen.end(), point.method) != seen.end()) continue;
        seen.push_back(point.method);
        scene.answers.push_back(answer(subject, point.method, scene.points));
    }
}

std::vector<std::size_t> best_front(const std::vector<FrontPoint>& points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::tuple(points[a].time, points[a].error) < std::tuple(points[b].time, points[b].error);
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
        if (front.empty() || points[i].error < kEqual * points[front.back()].error) front.push_back(i);
    return front;
}

}  // namespace relievo
