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

}  // namespace relievo
