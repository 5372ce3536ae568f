// Slopes over seams: no jump where texel rows bend, and heights equal all the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "brushes/sculptor.h"
#include "editor/session/surface/mesh_surface.h"
#include "editor/session/surface/seam_gap.h"
#include "editor/session/surface/seam_table.h"
#include "slope_jump.h"
#include "test_meshes.h"

namespace relievo::seam_slope_test {
namespace {

using namespace test;

constexpr double kAmplitude = 0.3;

// A smooth function of space at every owned texel.
HeightMap smooth_map(const Mesh& mesh, int size) {
    HeightMap map(size, size);
    set_owned(map, MeshSurface(mesh, displacement(0), map), [](const glm::dvec3& p) {
        return 65535 * (0.5 + 0.2 * std::sin(3 * p.x + p.y) * std::cos(2 * p.z) + 0.1 * p.y);
    });
    return map;
}

// A dab on the displaced surface's point over the base mesh's place that is nearest.
Dab dab_near(const MeshSurface& surface, const glm::dvec3& place) {
    const FacePoint at = surface.nearest_on_base(place);
    Dab dab;
    dab.face = at.face, dab.b1 = at.b1, dab.b2 = at.b2;
    return dab;
}

// Random maps, mirrored over their middle column: what gutters hold must leave them so.
void expect_mirror_maps_stay(const Mesh& mesh, int size, const SeamTable& table) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        HeightMap map = random_map(size, size, seed);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size / 2; ++x) map.set(size - 1 - x, y, map.at(x, y));
        fill_gutters(map, table);
        int different = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size / 2; ++x) different += map.at(size - 1 - x, y) != map.at(x, y);
        EXPECT_EQ(different, 0);
        EXPECT_EQ(max_seam_gap(mesh, map, Wrap::repeat, false), 0);
    }
}

struct Worst {
    double seam = 0, within = 0, mean_seam = 0;
};
Worst worst_of(const std::vector<SlopeJump>& jumps) {
    Worst worst;
    double seams = 0;
    for (const SlopeJump& jump : jumps) {
        (jump.seam ? worst.seam : worst.within) =
            std::max(jump.seam ? worst.seam : worst.within, jump.greatest);
        if (jump.seam) worst.mean_seam += jump.mean, ++seams;
    }
    worst.mean_seam /= std::max(seams, 1.0);
    return worst;
}

TEST(SeamSlope, light_sees_no_more_of_a_bent_seam_than_of_an_edge_within_an_island) {
    for (const auto& [a, b, c] : {std::array{4, 4, 4}, {6, 6, 7}, {16, 16, 23}}) {
        const Mesh mesh = box_sphere(a, b, c);
        constexpr int kSize = 512;
        const SeamTable table = build_seam_table(mesh, kSize, kSize, Wrap::repeat);
        EXPECT_EQ(table.corners.size(), 8u);
        HeightMap map = smooth_map(mesh, kSize);
        const HeightMap copies = with_copies_alone(map, table);
        fill_gutters(map, table);
        const Worst before = worst_of(slope_jumps(mesh, copies, displacement(kAmplitude)));
        const Worst after = worst_of(slope_jumps(mesh, map, displacement(kAmplitude)));
        EXPECT_GT(before.seam, 0.08) << a << b << c;
        EXPECT_GT(before.mean_seam, 0.02) << a << b << c;
        EXPECT_LT(after.seam, 1.1 * before.within) << a << b << c;
        EXPECT_LT(after.mean_seam, 0.05 * before.mean_seam) << a << b << c;
        EXPECT_EQ(max_seam_gap(mesh, map, Wrap::repeat, false), 0);
    }
}

TEST(SeamSlope, a_stroke_over_a_box_corner_leaves_no_line) {
    const Mesh mesh = box_sphere(6, 6, 7);
    constexpr int kSize = 512;
    HeightMap map(kSize, kSize);
    const MeshSurface surface(mesh, displacement(kAmplitude), map);
    Sculptor sculptor(map, surface);
    Brush brush;
    brush.radius = 0.35f;
    sculptor.begin(brush);
    const glm::dvec3 corner = glm::normalize(glm::dvec3(1, 1, 1));
    for (int i = -6; i <= 6; ++i) {
        sculptor.dab(dab_near(surface, corner + 0.05 * i * glm::normalize(glm::dvec3(1, -0.3, -0.7))));
        ASSERT_EQ(max_seam_gap(mesh, map, Wrap::repeat, false), 0);
    }
    sculptor.end();
    EXPECT_EQ(max_seam_gap(mesh, map, Wrap::repeat, false), 0);

    // Dab by dab as all at once.
    HeightMap again = map;
    fill_gutters(again, surface.seams());
    EXPECT_EQ(map.hash(), again.hash());

    const Worst after = worst_of(slope_jumps(mesh, map, displacement(kAmplitude)));
    const Worst before =
        worst_of(slope_jumps(mesh, with_copies_alone(map, surface.seams()), displacement(kAmplitude)));
    EXPECT_GT(before.seam, 0.15);
    EXPECT_LT(after.seam, 0.25 * before.seam);
    EXPECT_LT(after.seam, after.within);
    EXPECT_LT(after.mean_seam, 0.06 * before.mean_seam);
    sculptor.undo();
    EXPECT_EQ(map.hash(), HeightMap(kSize, kSize).hash());
}

TEST(SeamSlope, heights_stay_equal_on_cliffs_and_at_the_ends_of_the_range) {
    for (unsigned order = 0; order <= 8; ++order)
        for (const int size : {64, 192, 256}) {
            const Mesh mesh = box_sphere(3, 4, 5, order);
            const SeamTable table = build_seam_table(mesh, size, size, Wrap::repeat);
            for (unsigned seed = 1; seed <= 4; ++seed) {
                HeightMap map = random_map(size, size, seed);
                for (std::uint16_t& texel : map.texels()) texel = texel < 32768 ? 0 : 65535;
                fill_gutters(map, table);
                EXPECT_EQ(max_seam_gap(mesh, map, Wrap::repeat, true), 0) << order << ' ' << size;
            }
        }
}

TEST(SeamSlope, straight_rows_at_one_scale_keep_plain_copies) {
    for (const Mesh& mesh : {cut_cylinder(12), cut_strip(0, 1)})
        for (const int size : {64, 256}) {
            const SeamTable table = build_seam_table(mesh, size, size, Wrap::repeat);
            EXPECT_FALSE(table.copies.empty());
            EXPECT_TRUE(table.bends.empty());
            EXPECT_TRUE(table.corners.empty());
        }
}

// Two strips that mirror each other at their seam x = 0, laid out as mirror images too. The texel rows of
// strip row j meet the seam aslant, by `lean[j]` texels along it for one across.
Mesh herringbone(const std::vector<float>& lean) {
    MeshBuilder builder;
    const float height = 0.5f / static_cast<float>(lean.size() - 1);
    const auto corner = [&](float side, float i, std::size_t j) {
        const float v = 0.25f + height * static_cast<float>(j);
        return MeshBuilder::Corner{{side * i, 4 * v + lean[j] * i, 0.1f * i},
                                   {0.5f + side * (0.125f + 0.25f * i), v}};
    };
    for (std::size_t j = 0; j + 1 < lean.size(); ++j) {
        builder.quad(corner(-1, 1, j), corner(-1, 0, j), corner(-1, 0, j + 1), corner(-1, 1, j + 1));
        builder.quad(corner(1, 1, j + 1), corner(1, 0, j + 1), corner(1, 0, j), corner(1, 1, j));
    }
    return builder.build();
}

TEST(SeamSlope, a_plain_slope_along_a_bent_seam_has_no_jump_at_all) {
    for (const float lean : {0.25f, -0.5f, 1.0f}) {
        const Mesh mesh = herringbone({lean, lean, lean, lean});
        HeightMap map(256, 256);
        const MeshSurface surface(mesh, displacement(0), map);
        set_owned(map, surface, [](const glm::dvec3& p) { return 32768 + 3200 * p.y; });
        const HeightMap copies = with_copies_alone(map, surface.seams());
        fill_gutters(map, surface.seams());
        const auto jump = [&](const HeightMap& of) {  // away from the seam's ends, where nothing goes on
            std::vector<SlopeJump> jumps = slope_jumps(mesh, of, displacement(kAmplitude));
            std::erase_if(jumps, [&](const SlopeJump& j) {
                const auto at_end = [&](std::uint32_t p) {
                    return mesh.positions[p].y < 1.01f || mesh.positions[p].y > 2.99f;
                };
                return at_end(j.position[0]) || at_end(j.position[1]);
            });
            return worst_of(jumps).seam;
        };
        const double slope = kAmplitude * 3200 / 65535;
        EXPECT_GT(jump(copies), std::abs(double{lean}) * slope);
        EXPECT_LT(jump(map), 0.03 * slope) << lean << ": what rounding leaves of 50 counts a texel";
        EXPECT_EQ(max_seam_gap(mesh, map, Wrap::repeat, false), 0);
    }
}

TEST(SeamSlope, a_map_that_mirrors_itself_at_the_seam_keeps_doing_so) {
    const Mesh mesh = herringbone({0.3f, 0.7f, 0.1f, -0.6f, 0.2f});
    constexpr int kSize = 256;
    const SeamTable table = build_seam_table(mesh, kSize, kSize, Wrap::repeat);
    EXPECT_EQ(table.bends.size(), 128u);
    expect_mirror_maps_stay(mesh, kSize, table);
}

// Two strips one above the other, each its own mirror image in x; the plane of the mirror crosses their seam.
TEST(SeamSlope, a_map_that_mirrors_itself_across_the_seam_keeps_doing_so) {
    MeshBuilder builder;
    const auto corner = [](int i, int j, float v) {
        const float x = static_cast<float>(i) / 4, y = static_cast<float>(j);
        const float wide = y > 0 ? 1.5f : y < 0 ? 0.8f : 1.0f;
        return MeshBuilder::Corner{{x * wide, y - 0.3f * x * x, 0.1f * x * x}, {0.5f + 0.25f * x, v}};
    };
    for (int i = -4; i < 4; ++i)
        for (const int j : {-1, 0}) {
            const float v = j < 0 ? 0.125f : 0.625f;
            const auto a = corner(i, j, v), b = corner(i + 1, j, v), c = corner(i + 1, j + 1, v + 0.25f),
                       d = corner(i, j + 1, v + 0.25f);
            if (i < 0) {
                builder.quad(a, b, c, d);
            } else {
                builder.quad(b, c, d, a);
            }
        }
    const Mesh mesh = builder.build();
    constexpr int kSize = 128;
    const SeamTable table = build_seam_table(mesh, kSize, kSize, Wrap::repeat);
    EXPECT_EQ(table.bends.size(), 64u);
    expect_mirror_maps_stay(mesh, kSize, table);
}

// Slanted and scaled seams have no copies: the islands are extended over them.
TEST(SeamSlope, a_stroke_over_a_slanted_seam_leaves_no_line) {
    for (const auto& [turn, scale] : {std::pair{0.4, 1.0}, {0.0, 0.7}, {1.1, 0.6}, {0.785398, 1.0}}) {
        const Mesh mesh = cut_strip(turn, scale);
        HeightMap map(512, 512);
        const MeshSurface surface(mesh, displacement(kAmplitude), map);
        Sculptor sculptor(map, surface);
        Brush brush;
        brush.radius = 0.3f;
        sculptor.begin(brush);
        for (int i = 0; i <= 8; ++i)
            sculptor.dab(dab_near(surface, glm::dvec3(0.8 + 0.05 * i, 0.35 + 0.04 * i, 0)));
        sculptor.end();
        const Worst worst = worst_of(slope_jumps(mesh, map, displacement(kAmplitude)));
        EXPECT_LT(worst.seam, 0.05) << turn << ' ' << scale << ": 0.09 to 0.24 with texels' means beyond";
        EXPECT_LT(worst.mean_seam, 0.01) << turn << ' ' << scale;
        EXPECT_LE(max_seam_gap(mesh, map, Wrap::repeat, false), 10) << turn << ' ' << scale;
    }
}

// Six islands turned and scaled anyhow; strokes over three edges and a corner, of a radius of 17, 8 and 4 texels.
TEST(SeamSlope, strokes_over_islands_turned_anyhow_leave_no_line) {
    const Mesh mesh = turned_box_sphere(6);
    for (const auto& [size, most_jump, most_mean] :
         {std::tuple(1024, 0.1, 0.001), {512, 0.1, 0.0015}, {256, 0.22, 0.007}}) {
        HeightMap map(size, size);
        const MeshSurface surface(mesh, displacement(kAmplitude), map);
        Sculptor sculptor(map, surface);
        Brush brush;
        brush.radius = 0.2f;
        for (const auto& [place, way] : {std::pair(glm::dvec3(1, 1, 0.2), glm::dvec3(1, -1, 0.3)),
                                        {glm::dvec3(-1, 0.1, 1), glm::dvec3(1, 0.4, 1)},
                                        {glm::dvec3(0.3, -1, -1), glm::dvec3(0.1, 1, -1)},
                                        {glm::dvec3(-1, -1, 1), glm::dvec3(1, -0.3, 0.7)}}) {
            sculptor.begin(brush);
            for (int i = -8; i <= 8; ++i)
                sculptor.dab(dab_near(surface, glm::normalize(place) + 0.03 * i * glm::normalize(way)));
            sculptor.end();
        }
        const auto [low, high] = std::minmax_element(map.texels().begin(), map.texels().end());
        EXPECT_LE(max_seam_gap(mesh, map, Wrap::repeat, false), 0.01 * (*high - *low)) << size;
        const Worst worst = worst_of(slope_jumps(mesh, map, displacement(kAmplitude)));
        EXPECT_LT(worst.seam, most_jump) << size;
        EXPECT_LT(worst.mean_seam, most_mean) << size;
    }
}

// Stroke after stroke moves the texels beside the seams, and must not add up what it moves them by.
TEST(SeamSlope, many_weak_strokes_over_islands_turned_anyhow_leave_no_line) {
    const Mesh mesh = turned_box_sphere(6);
    for (const Tool tool : {Tool::draw, Tool::inflate}) {
        HeightMap map(1024, 1024);
        const MeshSurface surface(mesh, displacement(kAmplitude), map);
        Sculptor sculptor(map, surface);
        for (int pass = 0; pass < 7; ++pass)
            for (const auto& [place, way] : {std::pair(glm::dvec3(1, 1, 0.2), glm::dvec3(1, -1, 0.3)),
                                            {glm::dvec3(-1, 0.1, 1), glm::dvec3(1, 0.4, 1)},
                                            {glm::dvec3(0.3, -1, -1), glm::dvec3(0.1, 1, -1)}}) {
                Brush brush;
                brush.tool = pass > 0 ? tool : Tool::draw;
                brush.radius = pass > 0 ? 0.15f : 0.25f;
                brush.strength = pass > 0 ? 0.15f : 0.4f;
                sculptor.begin(brush);
                for (int i = -8; i <= 8; ++i)
                    sculptor.dab(dab_near(surface, glm::normalize(place) + 0.03 * i * glm::normalize(way)));
                sculptor.end();
            }
        const auto [low, high] = std::minmax_element(map.texels().begin(), map.texels().end());
        EXPECT_LE(max_seam_gap(mesh, map, Wrap::repeat, false), 0.01 * (*high - *low));
        const Worst worst = worst_of(slope_jumps(mesh, map, displacement(kAmplitude)));
        EXPECT_LT(worst.mean_seam, 0.001) << "0.0012 of draw, 0.0014 of inflate in older builds";
    }
}

// Masks and colours have no slope to pass: what they hold across a seam stays a copy.
TEST(SeamSlope, a_mask_keeps_plain_copies) {
    const Mesh mesh = herringbone({0.5f, 0.5f, 0.5f});
    HeightMap map(256, 256);
    const MeshSurface surface(mesh, displacement(kAmplitude), map);
    Sculptor sculptor(map, surface);
    Brush brush;
    brush.tool = Tool::mask;
    brush.radius = 0.2f;
    sculptor.begin(brush);
    Dab dab;
    dab.b2 = Dab::kBarycentricOne / 2;
    sculptor.dab(dab);
    sculptor.end();
    ASSERT_TRUE(sculptor.mask());
    const HeightMap copies = with_copies_alone(*sculptor.mask(), surface.seams());
    EXPECT_EQ(sculptor.mask()->hash(), copies.hash());
    EXPECT_NE(copies.hash(), HeightMap(256, 256, 0).hash());
}

}  // namespace
}  // namespace relievo::seam_slope_test
