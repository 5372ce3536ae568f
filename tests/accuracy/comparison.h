// How far a method's layers Z and N lie from the reference's.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "renderer/reference/reference.h"

namespace relievo::test {

// Rank statistics of a set of errors; 0 for an empty set.
struct ErrorRanks {
    double median = 0, p99 = 0, p999 = 0, most = 0;
};

struct OffPixel {
    enum class Kind { missed, invented, depth } kind;
    int x, y;
    double reference, method;  // depths
};

struct ImageComparison {
    int both = 0;                  // pixels that both hit
    int missed = 0, invented = 0;  // away from silhouettes
    int silhouette_missed = 0, silhouette_invented = 0;
    int off = 0;            // depth off by more than a hundredth of the amplitude, away from silhouettes
    int unexplained = 0;    // see count_unexplained
    ErrorRanks depth;       // |Z - reference| / |amplitude| over all pixels that both hit
    ErrorRanks depth_away;  // the same away from silhouettes
    ErrorRanks normal_deg;  // angle between N and the reference's
    std::vector<OffPixel> unexplained_examples;
    std::vector<OffPixel> examples;  // away from silhouettes, the first of every kind

    std::string text() const;
};

// A pixel lies at a silhouette when, within `reach` pixels of it, the reference hits and misses, or its depth
// leaves the tangent plane of a neighbour's hit by more than 0.2 |amplitude|. `depth` and `normal` as
// Renderer::read_back gives them.
ImageComparison compare_images(const ReferenceImage& reference, const Camera& camera,
                               const glm::dvec3& scene_origin, double amplitude, std::span<const float> depth,
                               std::span<const float> normal, int reach = 2);

// Counts, into `result`, the pixels (at silhouettes as well) where the method missed, invented or is off by
// more than a hundredth of the amplitude, and none of the reference's rays within 2e-3 pixels of the centre
// gives the method's answer: rounding of the ray cannot excuse them.
void count_unexplained(const ReferenceSurface& surface, const ReferenceImage& reference, const Camera& camera,
                       const glm::dvec3& scene_origin, double amplitude, std::span<const float> depth,
                       ImageComparison& result);

}  // namespace relievo::test
