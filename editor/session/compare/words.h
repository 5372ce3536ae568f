// How the report's tables word numbers.
#pragma once

#include <string>

#include "editor/session/compare/result.h"
#include "editor/session/text.h"

namespace relievo {

std::string error_text(double error);           // "3.4e-6", "0.18", "0"
std::string count_text(double count);           // "3.2", "120"
std::string ms_text(double ms);                 // "0.42", "12.3", "845"
std::string ratio_text(double ratio);           // "0.93", "-" for 0
std::string percent_text(double share);         // "0.4%"
std::string spread_text(const Spread& spread);  // "12.3 (12.1 to 13.0)"

// A rival's cell: "dt 0.001: 0.93 (0.97)", the primary frame's ratio and the preview's; or what there is none
// of.
std::string rival_text(const Rival& rival, const std::string& method);

}  // namespace relievo
