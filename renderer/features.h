// The only place that decides what a scene needs (DESIGN.md section 7): derived from scene, method and settings.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace relievo {

struct Feature {
    std::string name;    // "shadows", "min-max pyramid", "opacity maps", ...
    bool built = false;
    std::string reason;  // one clause: why it is built or left out
    std::uint64_t bytes = 0;  // device memory it takes; 0 for shader code
};

struct FeatureReport {
    std::vector<Feature> features;
    std::uint64_t bytes_total = 0;
};

}  // namespace relievo
