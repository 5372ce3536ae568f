// The surfaces and views that every method is judged on.
#pragma once

#include <string>
#include <vector>

#include "tests/reference/sample_surfaces.h"

namespace relievo::test {

struct NamedView {
    const char* name;
    glm::dvec3 eye, look_at;  // rebased space
    double median = 1e-5;     // of exact's depth error: more where the ray's own rounding is
};

// What the sampling method is held to on a surface.
enum class Sampled {
    within_limits,
    known_flaw,  // the prisms of irregular neighbours disagree, whatever the step (DESIGN.md section 1)
    no_promise,  // features thinner than its step, or cliffs
};

struct JudgedSurface {
    std::string name;  // letters, digits and underscores
    SampleSurface sample;
    std::vector<NamedView> views;
    Sampled sampled = Sampled::no_promise;
    // Pixels a view that `exact` is known to get wrong, with the reason in surfaces.cpp; 0: within all its
    // promises.
    int exact_wrong = 0;
    glm::dvec3 origin{0};  // of the scene: how far from the world's zero it lies
};

std::vector<std::string> judged_surface_names();
JudgedSurface judged_surface(const std::string& name);

}  // namespace relievo::test
