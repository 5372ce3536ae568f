// "Why this pixel": what a method did along one ray, triangle by triangle, in numbers and in words.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "editor/session/live_reference.h"
#include "renderer/renderer.h"

namespace relievo {

struct RayReport {
    // One visit of a triangle: its box was met, and the method looked for the surface in it.
    struct Visit {
        std::uint32_t object = 0,
                      face = 0;        // of the mesh as traced: where creases are mended, faces are added
        std::vector<TraceNote> notes;  // all but the box
        std::size_t steps = 0, cells = 0, roots = 0;
        std::optional<TraceNote> hit;
    };
    std::string method;
    glm::ivec2 pixel{0};
    Ray ray;                    // unit direction, rebased space
    std::vector<Visit> visits;  // in the order in which the boxes were met
    std::size_t steps = 0, cells = 0, roots = 0;
    std::uint32_t left_out = 0;  // notes beyond the log's length
    bool hit = false;
    double distance = 0;
    std::optional<std::size_t> hit_visit;  // whose answer the ray ended with
};

// Traces the ray through a pixel's centre once more, with notes taken.
RayReport report_ray(Renderer& renderer, const std::string& method, const glm::ivec2& pixel);

// A visit or a note in one line.
std::string describe(const RayReport::Visit& visit, const Scene& scene);
std::string describe(const TraceNote& note);
// What the reference says beside it: depth, triangle, and the error over the amplitude.
std::vector<std::string> describe(const RayReport& report, const ReferenceVerdict& verdict,
                                  const Scene& scene);
// Totals and outcome.
std::vector<std::string> summary(const RayReport& report, const Scene& scene);

// All of it, for the clipboard.
std::string full_text(const RayReport& report, const std::optional<ReferenceVerdict>& verdict,
                      const Scene& scene);

}  // namespace relievo
