// What a dab costs is known before it is made.
#include "brushes/dab_cost.h"

#include <gtest/gtest.h>

#include "chart_surface.h"

namespace relievo::dab_cost_test {
namespace {

TEST(DabCost, CountsTexelsAndCopiesAndResampling) {
    const HeightMap map(64, 64, std::uint16_t{32768});
    const ChartSurface surface(map, {{{0, 0}, {1, 1}, {0, 0}, {64, 0}, {0, 64}}}, 0.1f);
    const SurfacePoint middle{{0.5f, 0.5f, 0}, {0, 0, 1}, {0.5f, 0.5f, 0}, {0, 0, 1}};
    Brush brush;
    brush.radius = 2.0f;
    DabCost cost = dab_cost(brush, middle, surface);
    EXPECT_EQ(cost.texels, 64u * 64u);
    EXPECT_EQ(cost.copies, 1u);
    EXPECT_EQ(cost.work, 64.0 * 64.0);

    brush.mirror_x = brush.mirror_z = true;
    brush.radial = 5;
    cost = dab_cost(brush, middle, surface);
    EXPECT_EQ(cost.copies, 20u);
    EXPECT_EQ(cost.work, 20 * 64.0 * 64.0);

    brush.tool = Tool::grab;
    EXPECT_GT(dab_cost(brush, middle, surface).work, 5 * cost.work);
    brush.tool = Tool::draw;
    brush.radius = 0.1f;
    EXPECT_NEAR(static_cast<double>(dab_cost(brush, middle, surface).texels), 3.14159 * 6.4 * 6.4, 12);
    brush.radius = 1e-6f;
    EXPECT_LE(dab_cost(brush, middle, surface).texels, 1u);
}

}  // namespace
}  // namespace relievo::dab_cost_test
