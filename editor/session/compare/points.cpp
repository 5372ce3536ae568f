// See points.h.
#include "editor/session/compare/points.h"

#include <algorithm>
#include <cstdio>

namespace relievo {

std::string swept_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

namespace {

std::vector<PointChoice> sweep(const Method& method, bool procedural) {
    std::vector<PointChoice> points{{&method, {}, std::string(method.name)}};
    const bool own = procedural && std::any_of(method.parameters.begin(), method.parameters.end(),
                                               [](const auto& p) { return !p.procedural_sweep.empty(); });
    for (const MethodParameter& parameter : method.parameters) {
        const std::span<const double> values = own ? parameter.procedural_sweep : parameter.sweep;
        if (values.empty()) continue;
        std::vector<PointChoice> longer;
        for (const PointChoice& point : points) {
            for (const double value : values) {
                longer.push_back(point);
                longer.back().swept[std::string(parameter.name)] = value;
                longer.back().label.append(" ").append(parameter.name).append(" ").append(swept_text(value));
            }
        }
        points = std::move(longer);
    }
    return points;
}

}  // namespace

std::vector<PointChoice> comparison_points(const std::vector<std::string>& names, bool procedural) {
    std::vector<std::vector<PointChoice>> sweeps;
    for (const std::string& name : names) sweeps.push_back(sweep(find_method(name), procedural));
    std::vector<PointChoice> points;
    bool more = true;
    for (std::size_t i = 0; more; ++i) {
        more = false;
        for (const auto& of_method : sweeps) {
            if (i >= of_method.size()) continue;
            points.push_back(of_method[i]);
            more = true;
        }
    }
    return points;
}

}  // namespace relievo
