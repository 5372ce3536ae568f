// See promises.h.
#include "renderer/stability/promises.h"

#include <algorithm>
#include <cstdio>

namespace relievo::stability {
namespace {

// DESIGN.md section 8, and the limits of the method `exact`.
constexpr double kMedian = 1e-5, kP99 = 1e-4, kNormalDeg = 0.2;
constexpr double kNearMedian = 1e-4;

std::string sentence(const char* what, double value, double limit) {
    char line[160];
    std::snprintf(line, sizeof line, "%s %.3g, at most %.3g is promised", what, value, limit);
    return line;
}

void hold(std::vector<std::string>& failures, const char* what, double value, double limit) {
    if (!(value <= limit)) failures.push_back(sentence(what, value, limit));
}

}  // namespace

Promise promise_of(std::string_view method) {
    if (method == "exact") return {.method = method, .right = true};
    if (method == "pdm") return {.method = method, .parameters = {{"dt", 0.001}, {"jitter", 0}}, .sampled = true};
    if (method == "tessellated") return {.method = method, .parameters = {{"density", 0.25}}, .may_refuse = true};
    if (method == "dbvh") return {.method = method, .near = true};
    if (method == "march") return {.method = method, .parameters = {{"steps", 2000}}, .sampled = true};
    return {.method = method};
}

std::vector<std::string> right_failures(const ImageComparison& errors) {
    std::vector<std::string> failures;
    hold(failures, "missed away from silhouettes:", errors.missed, 0);
    hold(failures, "invented away from silhouettes:", errors.invented, 0);
    hold(failures, "pixels that no neighbouring ray explains:", errors.unexplained, 0);
    hold(failures, "median of the depth error", errors.depth.median, kMedian);
    hold(failures, "p99 of the depth error away from silhouettes", errors.depth_away.p99, kP99);
    hold(failures, "median of the normal's angle in degrees", errors.normal_deg.median, kNormalDeg);
    return failures;
}

std::vector<std::string> near_failures(const ImageComparison& errors) {
    std::vector<std::string> failures;
    hold(failures, "missed away from silhouettes:", errors.missed, 0);
    hold(failures, "invented away from silhouettes:", errors.invented, 0);
    hold(failures, "median of the depth error", errors.depth.median, kNearMedian);
    return failures;
}

std::vector<std::string> sampled_failures(const ImageComparison& errors, Sampled held_to) {
    std::vector<std::string> failures;
    if (held_to == Sampled::known_flaw) hold(failures, "median of the depth error", errors.depth.median, 0.1);
    if (held_to != Sampled::within_limits) return failures;
    hold(failures, "missed away from silhouettes:", errors.missed, 3);
    hold(failures, "invented away from silhouettes:", errors.invented, 3);
    hold(failures, "median of the depth error", errors.depth.median, 1e-3);
    return failures;
}

std::span<const KnownLimit> known_limits() {
    return {};  // none at the moment
}

const KnownLimit* find_known_limit(std::string_view method, std::string_view name) {
    const auto limits = known_limits();
    const auto found = std::find_if(limits.begin(), limits.end(), [&](const KnownLimit& l) {
        return l.method == method && l.name == name;
    });
    return found == limits.end() ? nullptr : &*found;
}

}  // namespace relievo::stability
