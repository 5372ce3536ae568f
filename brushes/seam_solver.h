// Damped sparse least squares for seam equations; the paper and our deviations stand in seams.h.
#pragma once

#include <cstddef>
#include <vector>

namespace relievo {

struct SeamSystem {
    struct Entry {
        std::size_t row, column;  // equation, unknown
        double weight;
    };
    std::vector<Entry> entries;    // a place that occurs twice adds up
    std::vector<double> residual;  // of each equation: what the unknowns' change must make up, counts
    std::size_t unknowns = 0;
    double relief = 0.0;  // counts from the lowest to the highest texel here; differences are judged by it
};

// The change of each unknown, counts. One fixed order of arithmetic: the same bits at every run.
std::vector<double> solve_seam(const SeamSystem& system);

}  // namespace relievo
