#include "editor/session/surface/seam_gap.h"

#include <algorithm>
#include <cmath>

#include "editor/session/surface/seam_equations.h"
#include "editor/session/surface/uv_borders.h"

namespace relievo {
namespace {

constexpr double kSamplesPerTexel = 8;
constexpr double kMostSamples = 1 << 23;
constexpr double kRounding = 1e-6;  // counts; what double arithmetic leaves of two equal heights

// A float's rounding of texture coordinates is not the map's fault: aligned sides are measured where they
// were meant.
UvSide meant(UvSide side) {
    for (glm::dvec2* p : {&side.from, &side.to}) *p = {snapped(p->x), snapped(p->y)};
    return side;
}

double gap(const UvSeam& seam, const HeightMap& map, const MapGrid& grid) {
    const UvSide a = seam.aligned ? meant(seam.a) : seam.a, b = seam.aligned ? meant(seam.b) : seam.b;
    double largest = 0;
    const auto measure = [&](double t) {
        const double height_a = bilinear(map.texels(), bilinear_taps(grid, a.from + (a.to - a.from) * t));
        const double height_b = bilinear(map.texels(), bilinear_taps(grid, b.from + (b.to - b.from) * t));
        largest = std::max(largest, std::abs(height_a - height_b));
    };
    const double samples = std::ceil(std::max(a.length(), b.length()) * kSamplesPerTexel);
    const int count = static_cast<int>(std::clamp(samples, 1.0, kMostSamples));
    for (int i = 0; i <= count; ++i) measure(static_cast<double>(i) / count);
    for (const double t : cell_crossings(a)) measure(t);
    for (const double t : cell_crossings(b)) measure(t);
    return largest < kRounding ? 0 : largest;
}

}  // namespace

std::vector<SeamGap> seam_gaps(const Mesh& mesh, const HeightMap& map, Wrap wrap) {
    const MapGrid grid{map.width(), map.height(), wrap};
    std::vector<SeamGap> gaps;
    for (const UvSeam& seam : find_uv_borders(mesh, grid).seams) {
        gaps.push_back({{seam.position[0], seam.position[1]}, seam.aligned, gap(seam, map, grid)});
    }
    return gaps;
}

double max_seam_gap(const Mesh& mesh, const HeightMap& map, Wrap wrap, bool aligned_only) {
    double largest = 0;
    for (const SeamGap& g : seam_gaps(mesh, map, wrap)) {
        if (g.aligned || !aligned_only) largest = std::max(largest, g.counts);
    }
    return largest;
}

}  // namespace relievo
