// The verb `compare` by its two ways: over scenes, or over the extreme cases of the stability suite.
#pragma once

#include <string>
#include <vector>

#include "editor/cli/verbs.h"

namespace relievo {

struct CompareVerb {
    std::vector<std::string> scenes;
    std::string folder, methods;
    std::string cases;  // of the stability suite
    double budget_s = 0;
    bool stability = false;
    CommonOptions common;
    MethodOptions method;  // its --path
    PictureOptions picture;
};

// Exit status 1 when a method breaks a promise. Throws std::invalid_argument.
int run_compare_stability(const CompareVerb& verb);

}  // namespace relievo
