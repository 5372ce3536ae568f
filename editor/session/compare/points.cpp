// See points.h.
#include "editor/session/compare/points.h"

#include <cstdio>

namespace relievo {

std::string swept_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

namespace {

std::vector<PointChoice> sweep(const Method& method) {
    std::vector<PointChoice> points{{&method, {}, std::string(method.name)}};
    for (const MethodParameter& parameter : method.parameters) {
        if (parameter.sweep.empty()) continue;
        std::vector<PointChoice> longer;
        for (const PointChoice& point : points) {
            for (const double value : parameter.sweep) {
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

std::vector<PointChoice> comparison_points(const std::vector<std::string>& names) {
    std::vector<std::vector<PointChoice>> sweeps;
    for (const std::string& name : names) sweeps.push_back(sweep(find_method(name)));
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
