// The explicit registry over the list in all.h.
#include "renderer/methods/registry.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "renderer/methods/all.h"

namespace relievo {
namespace {

#define RELIEVO_ADDRESS(method) &method,
constexpr const Method* kMethods[] = {RELIEVO_METHODS(RELIEVO_ADDRESS)};
#undef RELIEVO_ADDRESS

std::string number(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

std::string known_names(const MethodParameter& p) {
    std::string text;
    for (std::size_t i = 0; i < p.names.size(); ++i)
        text += (i == 0 ? "" : ", ") + std::to_string(i) + " (" + std::string(p.names[i]) + ")";
    return text;
}

const MethodParameter& find_parameter(const Method& method, const std::string& name) {
    std::string known;
    for (const MethodParameter& p : method.parameters) {
        if (p.name == name) return p;
        known += (known.empty() ? "" : ", ") + std::string(p.name);
    }
    throw std::invalid_argument("method '" + std::string(method.name) + "' has no parameter '" + name +
                                "'; it has: " + known);
}

}  // namespace

std::span<const Method* const> methods() { return kMethods; }

const Method& find_method(std::string_view name) {
    if (name.empty()) return *kMethods[0];
    std::string known;
    for (const Method* m : kMethods) {
        if (m->name == name) return *m;
        known += (known.empty() ? "" : ", ") + std::string(m->name);
    }
    throw std::invalid_argument("there is no method '" + std::string(name) + "'; methods: " + known);
}

std::optional<double> named_value(std::string_view parameter, std::string_view word) {
    for (const Method* m : kMethods)
        for (const MethodParameter& p : m->parameters)
            for (std::size_t i = 0; p.name == parameter && i < p.names.size(); ++i)
                if (p.names[i] == word) return static_cast<double>(i);
    return std::nullopt;
}

double parameter_word(const Method& method, const std::string& parameter, const std::string& word) {
    const MethodParameter& p = find_parameter(method, parameter);
    for (std::size_t i = 0; i < p.names.size(); ++i)
        if (p.names[i] == word) return static_cast<double>(i);
    throw std::invalid_argument("method parameter '" + parameter + "' is \"" + word + "\", must be " +
                                (p.is_switch         ? "true or false"
                                 : !p.names.empty() ? known_names(p)
                                                    : "a number"));
}

std::map<std::string, double> resolve_parameters(const Method& method, const std::map<std::string, double>& given) {
    std::map<std::string, double> result;
    for (const MethodParameter& p : method.parameters) result[std::string(p.name)] = p.standard;
    for (const auto& [name, value] : given) {
        const MethodParameter& p = find_parameter(method, name);
        const bool fits = std::isfinite(value) && value >= p.low && value <= p.high &&
                          (!p.is_switch || value == 0 || value == 1) &&
                          (p.names.empty() || value == std::floor(value));
        if (!fits) {
            throw std::invalid_argument("method parameter '" + name + "' is " + number(value) + ", must be " +
                                        (p.is_switch      ? "0 or 1"
                                         : !p.names.empty() ? known_names(p)
                                                            : "in [" + number(p.low) + ", " + number(p.high) + "]"));
        }
        result[name] = value;
    }
    return result;
}

}  // namespace relievo
