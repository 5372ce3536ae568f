// What users are promised of each method, as limits of its comparison with the reference.
#pragma once

#include <gtest/gtest.h>

#include "tests/accuracy/comparison.h"

namespace relievo::test {

inline void expect_exact(const ImageComparison& result) {
    EXPECT_EQ(result.missed, 0);
    EXPECT_EQ(result.invented, 0);
    EXPECT_EQ(result.unexplained, 0);
    EXPECT_LE(result.depth.median, 1e-5);
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
