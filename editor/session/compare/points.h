// The points of a comparison: every method, and every value of the parameters that its description sweeps.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "renderer/methods/registry.h"

namespace relievo {

struct PointChoice {
    const Method* method = nullptr;
    std::map<std::string, double> swept;
    std::string label;  // "pdm dt 0.002"
};

// In the order in which a short budget should spend itself: the first point of every method, then the second
// of every method, and so on; coarse and quick ones first. `procedural`: the scene's heights are.
std::vector<PointChoice> comparison_points(const std::vector<std::string>& methods, bool procedural = false);

std::string swept_text(double value);  // "0.0005"
// By its name where the method's parameter has one: "triangles".
std::string swept_text(const std::string& method, const std::string& parameter, double value);
// Of a method that sweeps several parameters, the values of all but the last: points that differ in that one
// alone are of one line.
std::string swept_line(const std::string& method, const std::map<std::string, double>& swept);

}  // namespace relievo
