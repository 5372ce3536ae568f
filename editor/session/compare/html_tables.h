// The tables of the comparison's page.
#pragma once

#include <string>
#include <vector>

#include "editor/session/compare/overview.h"
#include "editor/session/compare/result.h"

namespace relievo {

// Points by method, in the order of the comparison's methods; the order of measuring mixes them.
std::vector<const ComparedPoint*> by_method(const Comparison& comparison, const ComparedScene& scene);

std::string overview_table(const TextTable& rows);
std::string speed_table(const Comparison& comparison);  // every scene's answers
std::string error_table(const Comparison& comparison, const ComparedScene& scene);
std::string cost_table(const Comparison& comparison, const ComparedScene& scene);
std::string angle_table(const Comparison& comparison, const ComparedScene& scene);

}  // namespace relievo
