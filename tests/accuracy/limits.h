// What users are promised of each method, as limits of its comparison with the reference.
#pragma once

#include <gtest/gtest.h>

#include "renderer/judge/image_comparison.h"

namespace relievo::test {

// `wrong`: pixels that are known to be.
inline void expect_exact(const ImageComparison& result, int wrong = 0, double median = 1e-5) {
    EXPECT_LE(result.missed, wrong);
    EXPECT_LE(result.invented, wrong);
    EXPECT_LE(result.unexplained, wrong);
    EXPECT_LE(result.depth.median, median);
    EXPECT_LE(result.depth_away.p99, 1e-4);
    EXPECT_LE(result.normal_deg.median, 0.2);
}

// At dt 0.001, on a ball and on planes.
inline void expect_sampled(const ImageComparison& result) {
    EXPECT_LE(result.depth.median, 1e-3);
    EXPECT_LE(result.missed, 3);
    EXPECT_LE(result.invented, 3);
}

}  // namespace relievo::test
