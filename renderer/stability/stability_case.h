// A stiff or extreme case of DESIGN.md section 8: surfaces, the cameras that look at them, and rays of its
// own.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "renderer/renderer.h"
#include "renderer/stability/sample_surfaces.h"

namespace relievo::stability {

struct NamedView {
    std::string name;
    glm::dvec3 eye, look_at;  // rebased space; up is +z
};

struct RaySet {
    std::string name;
    std::vector<Ray> rays;  // rebased space
};

// What a method that samples is held to (promises.h).
enum class Sampled {
    within_limits,  // smooth and regular
    known_flaw,     // irregular neighbours, whose prisms disagree whatever the step (DESIGN.md section 1)
    no_promise,     // cliffs, features thinner than a step, and all else
};

constexpr int kCaseSize = 64;  // pixels a side of the images

struct Case {
    std::vector<SampleSurface> objects;
    std::vector<NamedView> views;
    std::vector<RaySet> rays;
    glm::dvec3 origin{0};  // of the scene: how far from the world's zero it lies
    Sampled sampled = Sampled::no_promise;
    // Why float cannot represent the answer here: then no method is held to errors. Empty: it can.
    std::string beyond_float;
    int size = kCaseSize;

    Scene scene(const NamedView& view) const;
    std::vector<HeightView> maps() const;
    ReferenceSurface reference() const;
};

struct CaseEntry {
    std::string group;  // heading of the matrix: "maps", "amplitudes", ...
    std::string name;   // letters, digits, underscores
    std::string what;   // one clause
    std::function<Case()> make;
};

// All cases, in the order of the matrix. Made anew at every call of `make`.
const std::vector<CaseEntry>& cases();
const CaseEntry& find_case(const std::string& name);  // std::invalid_argument

// One list a file; cases() joins them.
std::vector<CaseEntry> map_cases();
std::vector<CaseEntry> amplitude_cases();
std::vector<CaseEntry> mesh_cases();
std::vector<CaseEntry> uv_cases();
std::vector<CaseEntry> place_cases();
std::vector<CaseEntry> ray_cases();
std::vector<CaseEntry> procedural_cases();

}  // namespace relievo::stability
