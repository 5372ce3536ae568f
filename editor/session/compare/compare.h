// Methods and their quality settings over scenes: errors beside times (the verb `compare`).
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "editor/session/compare/result.h"
#include "renderer/renderer.h"

namespace relievo {

struct CompareOptions {
    std::vector<std::filesystem::path> scenes;
    std::filesystem::path folder;      // made if need be
    std::vector<std::string> methods;  // empty: all of the registry
    double budget_s = 0;               // 0: as long as it takes
    int width = 0, height = 0;         // of the frames; 0: each scene's
    std::string device;
    TracePath path = TracePath::automatic;
};

struct CompareProgress {
    std::string what;         // "orb (2 of 8): round 3 of 9"
    double done = 0;          // [0, 1]
    double seconds_left = 0;  // a guess
};

struct CompareListener {
    std::function<void(const CompareProgress&)> progress;
    std::function<void(const ComparedScene&)> scene_done;
};

// "exact,pdm" to names of the registry, each once. Throws std::invalid_argument naming --methods.
std::vector<std::string> parse_methods(const std::string& list);

// About what it takes at least, however small the budget: one method is compiled and measured once on every
// scene.
double least_seconds(const CompareOptions& options);

// Measures, and writes the folder (report.h), afresh after every scene: what is there is whole even if the
// run is ended. Throws std::invalid_argument on bad input, before anything is measured, std::runtime_error
// when Vulkan fails.
Comparison compare_methods(const CompareOptions& options, const CompareListener& listener = {});

}  // namespace relievo
