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

// Null: a method that is not of the registry.
const Method* known_method(const std::string& name) {
    const auto all = methods();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Method* m) { return m->name == name; });
    return found == all.end() ? nullptr : *found;
}

std::string value_text(const MethodParameter& parameter, double value) {
    const bool named = value >= 0 && value < static_cast<double>(parameter.names.size());
    return named ? std::string(parameter.names[static_cast<std::size_t>(value)]) : swept_text(value);
}

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
                longer.back().label.append(" ").append(parameter.name).append(" ").append(value_text(parameter, value));
            }
        }
        points = std::move(longer);
    }
    return points;
}

}  // namespace

std::string swept_text(const std::string& method, const std::string& parameter, double value) {
    if (const Method* known = known_method(method))
        for (const MethodParameter& p : known->parameters)
            if (p.name == parameter) return value_text(p, value);
    return swept_text(value);
}

std::string swept_line(const std::string& method, const std::map<std::string, double>& swept) {
    std::string line, last;
    if (const Method* known = known_method(method))
        for (const MethodParameter& p : known->parameters) {
            const auto value = swept.find(std::string(p.name));
            if (value == swept.end()) continue;
            line += last;
            last = value_text(p, value->second) + " ";
        }
    return line;
}

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
