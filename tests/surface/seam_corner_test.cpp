// The last half texel of a seam: corners where islands meet, seams that end inside an island.
#include <gtest/gtest.h>

#include <algorithm>

#include "editor/session/surface/seam_gap.h"
#include "editor/session/surface/seam_table.h"
#include "test_meshes.h"

namespace relievo::seam_corner_test {
namespace {

using namespace test;

// `islands` squares around one vertex, each a patch of its own in the map: 3 make a box corner, 4 lie flat.
Mesh fan(int islands) {
    MeshBuilder builder;
    const auto spoke = [&](double i, double r) {
        const double angle = 6.283185307179586 * (i < islands ? i : i - islands) / islands;
        return glm::vec3(r * std::cos(angle), r * std::sin(angle), 0.1 * r);
    };
    for (int i = 0; i < islands; ++i) {
        const glm::vec2 at(0.125f + 0.25f * static_cast<float>(i % 3),
                           0.125f + 0.25f * static_cast<float>(i / 3));
        constexpr float k = 0.125f;
        builder.quad({glm::vec3(0), at}, {spoke(i, 1), at + glm::vec2(k, 0)},
                     {spoke(i + 0.5, 1.4), at + glm::vec2(k, k)}, {spoke(i + 1, 1), at + glm::vec2(0, k)});
    }
    return builder.build();
}

// One island of `quarters` squares around a vertex at the island's middle; the first and last spoke are one
// seam.
Mesh cone(int quarters) {
    MeshBuilder builder;
    const auto spoke = [&](double i, double r) {
        const double angle = 6.283185307179586 * (i < quarters ? i : i - quarters) / quarters;
        return glm::vec3(r * std::cos(angle), r * std::sin(angle), r);
    };
    constexpr float k = 0.25f;
    const glm::vec2 ring[9] = {{k, 0}, {k, k}, {0, k}, {-k, k}, {-k, 0}, {-k, -k}, {0, -k}, {k, -k}, {k, 0}};
    const glm::vec2 middle(0.5f);
    for (int i = 0; i < quarters; ++i) {
        builder.quad({glm::vec3(0), middle}, {spoke(i, 1), middle + ring[2 * i]},
                     {spoke(i + 0.5, 1.4), middle + ring[2 * i + 1]},
                     {spoke(i + 1, 1), middle + ring[2 * i + 2]});
    }
    return builder.build();
}

double gap(const Mesh& mesh, int size) {
    const SeamTable table = build_seam_table(mesh, size, size, Wrap::repeat);
    double largest = 0;
    for (unsigned seed = 1; seed <= 5; ++seed) {
        HeightMap map = random_map(size, size, seed);
        fill_gutters(map, table);
        largest = std::max(largest, max_seam_gap(mesh, map, Wrap::repeat, true));
    }
    return largest;
}

TEST(SeamCorner, three_islands_at_a_vertex) {
    EXPECT_EQ(gap(fan(3), 64), 0);
    EXPECT_EQ(gap(fan(3), 32), 0);
    EXPECT_EQ(gap(fan(3), 36), 0);  // on texel centres
}

TEST(SeamCorner, four_islands_at_a_vertex) {
    EXPECT_EQ(gap(fan(4), 64), 0);
    EXPECT_EQ(gap(fan(4), 36), 0);
}

TEST(SeamCorner, five_islands_leave_equations_at_the_vertex_alone) {
    const SeamTable table = build_seam_table(fan(5), 64, 64, Wrap::repeat);
    EXPECT_EQ(table.equations.size(), 5u);
    EXPECT_EQ(gap(fan(5), 36), 0);  // on texel centres the corner texels are shared
}

TEST(SeamCorner, a_seam_that_ends_inside_an_island) {
    for (const int quarters : {1, 2, 3}) {
        EXPECT_EQ(gap(cone(quarters), 64), 0) << quarters;
        EXPECT_EQ(gap(cone(quarters), 33), 0) << quarters;  // on texel centres
        EXPECT_TRUE(build_seam_table(cone(quarters), 64, 64, Wrap::repeat).equations.empty()) << quarters;
    }
}

TEST(SeamCorner, three_quarters_cost_one_owned_texel) {
    const SeamTable table = build_seam_table(cone(3), 64, 64, Wrap::repeat);
    const auto owned = std::count_if(table.copies.begin(), table.copies.end(), [](const SeamCopy& copy) {
        const auto x = static_cast<int>(copy.gutter % 64), y = static_cast<int>(copy.gutter / 64);
        return x >= 16 && x < 48 && y >= 16 && y < 48 && !(x >= 32 && y < 32);
    });
    EXPECT_EQ(owned, 1);
}

}  // namespace
}  // namespace relievo::seam_corner_test
