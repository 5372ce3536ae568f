// Seams: exact where both sides run along texel rows, equations elsewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "editor/session/surface/mesh_surface.h"
#include "editor/session/surface/seam_gap.h"
#include "editor/session/surface/seam_table.h"
#include "test_meshes.h"

namespace relievo::seam_test {
namespace {

using namespace test;

void expect_well_formed(const SeamTable& table) {
    std::set<std::uint32_t> gutters, sources;
    for (const SeamCopy& copy : table.copies) {
        EXPECT_TRUE(gutters.insert(copy.gutter).second) << "gutter twice: " << copy.gutter;
        sources.insert(copy.source);
    }
    for (const std::uint32_t source : sources) EXPECT_FALSE(gutters.contains(source)) << source;
    EXPECT_TRUE(std::is_sorted(table.copies.begin(), table.copies.end(),
                               [](const SeamCopy& a, const SeamCopy& b) { return a.source < b.source; }));
    for (const SeamEquation& e : table.equations) {
        double sum = 0;
        for (std::size_t i = 0; i < 8; ++i) {
            EXPECT_FALSE(gutters.contains(e.texel[i]) && e.weight[i] != 0);
            sum += static_cast<double>(e.weight[i]);
        }
        EXPECT_NEAR(sum, 0, 1e-6);
    }
}

// The largest gap along aligned seams of a map with random texels once the copies are applied.
double gap_after_copies(const Mesh& mesh, int width, int height, Wrap wrap = Wrap::repeat) {
    const SeamTable table = build_seam_table(mesh, width, height, wrap);
    expect_well_formed(table);
    double largest = 0;
    for (unsigned seed = 1; seed <= 3; ++seed) {
        HeightMap map = random_map(width, height, seed);
        EXPECT_GT(max_seam_gap(mesh, map, wrap, true), 1000);
        fill_gutters(map, table);
        largest = std::max(largest, max_seam_gap(mesh, map, wrap, true));
    }
    return largest;
}

TEST(Seam, six_islands_of_a_box_sphere_close_exactly) {
    for (const auto& [a, b, c] : {std::tuple{4, 4, 4}, {6, 6, 7}, {16, 16, 23}}) {
        const Mesh mesh = box_sphere(a, b, c);
        for (const int size : {256, 512, 1024}) {
            EXPECT_EQ(gap_after_copies(mesh, size, size), 0) << a << b << c << " at " << size;
            EXPECT_TRUE(build_seam_table(mesh, size, size, Wrap::repeat).equations.empty());
        }
    }
}

TEST(Seam, islands_turned_and_mirrored_in_any_way_close_exactly) {
    for (unsigned order = 1; order <= 40; ++order) {
        const Mesh mesh = box_sphere(3, 4, 5, order);
        EXPECT_EQ(gap_after_copies(mesh, 256, 256), 0) << order;
        EXPECT_TRUE(build_seam_table(mesh, 256, 256, Wrap::clamp).equations.empty()) << order;
    }
}

TEST(Seam, a_map_that_is_not_square_nor_a_power_of_two) {
    EXPECT_EQ(gap_after_copies(box_sphere(4, 4, 4, 3), 192, 192), 0);
    EXPECT_EQ(gap_after_copies(box_sphere(4, 4, 4), 128, 128), 0);  // two texels a cell
    const SeamTable table = build_seam_table(box_sphere(4, 4, 4, 3), 512, 128, Wrap::repeat);
    expect_well_formed(table);  // turned islands have two scales along a seam
    EXPECT_FALSE(table.equations.empty());
}

TEST(Seam, a_cylinder_cut_open_closes_up_to_its_open_ends) {
    const Mesh mesh = cut_cylinder(12);
    EXPECT_EQ(gap_after_copies(mesh, 64, 64), 0);
    EXPECT_EQ(gap_after_copies(mesh, 256, 64), 0);
    EXPECT_TRUE(build_seam_table(mesh, 64, 64, Wrap::repeat).equations.empty());
}

TEST(Seam, texels_past_an_open_border_repeat_the_border) {
    const Mesh mesh = cut_cylinder(12);
    HeightMap map = random_map(64, 64, 5);
    fill_gutters(map, build_seam_table(mesh, 64, 64, Wrap::repeat));
    for (int x = 8; x < 56; ++x) {
        EXPECT_EQ(map.at(x, 15), map.at(x, 16));
        EXPECT_EQ(map.at(x, 48), map.at(x, 47));
    }
}

TEST(Seam, a_seam_on_texel_centres_shares_its_border_texels) {
    // 96 texels are 1.5 a 64th: the islands' borders lie on texel centres or boundaries by turns.
    EXPECT_EQ(gap_after_copies(box_sphere(4, 4, 4), 96, 96), 0);
    // Both sides of a strip's cut on texel centres: u = 3/8 and 5/8 of 36 texels are 13.5 and 22.5.
    EXPECT_EQ(gap_after_copies(cut_strip(0, 1), 36, 36), 0);
}

TEST(Seam, quarter_texel_phases_close_where_they_are_complementary) {
    for (int size = 33; size < 140; ++size) {
        const Mesh mesh = box_sphere(4, 4, 4, static_cast<unsigned>(size));
        const SeamTable table = build_seam_table(mesh, size, size, Wrap::repeat);
        expect_well_formed(table);
        HeightMap map = random_map(size, size, 1);
        fill_gutters(map, table);
        if (table.equations.empty()) {
            EXPECT_EQ(max_seam_gap(mesh, map, Wrap::repeat, true), 0) << size;
        }
    }
}

TEST(Seam, whole_repeats_apart_is_no_seam) {
    // A closed band: u runs from 0 to 1, and the last cell's right side is the first one's left.
    MeshBuilder builder;
    const auto corner = [](int i, int j) {
        const float angle = 6.2831853f * static_cast<float>(i % 8) / 8;
        return MeshBuilder::Corner{{std::cos(angle), std::sin(angle), static_cast<float>(j)},
                                   {static_cast<float>(i) / 8, 0.25f + 0.5f * static_cast<float>(j)}};
    };
    for (int i = 0; i < 8; ++i) builder.quad(corner(i, 0), corner(i + 1, 0), corner(i + 1, 1), corner(i, 1));
    const Mesh mesh = builder.build();
    EXPECT_TRUE(seam_gaps(mesh, random_map(64, 64, 1), Wrap::repeat).empty());
    EXPECT_EQ(seam_gaps(mesh, random_map(64, 64, 1), Wrap::clamp).size(), 1u);
    EXPECT_EQ(gap_after_copies(mesh, 64, 64, Wrap::clamp), 0);
}

TEST(Seam, texture_coordinates_apart_by_a_floats_rounding_are_no_seam) {
    MeshBuilder builder;
    const float a = 0.3f, b = std::nextafter(a, 1.0f);
    builder.quad({{0, 0, 0}, {0.1f, 0}}, {{1, 0, 0}, {a, 0}}, {{1, 1, 0}, {a, 1}}, {{0, 1, 0}, {0.1f, 1}});
    builder.quad({{1, 0, 0}, {b, 0}}, {{2, 0, 0}, {0.6f, 0}}, {{2, 1, 0}, {0.6f, 1}}, {{1, 1, 0}, {b, 1}});
    EXPECT_TRUE(seam_gaps(builder.build(), HeightMap(512, 512), Wrap::clamp).empty());
}

TEST(Seam, a_face_folded_onto_the_seam_hides_no_seam) {
    MeshBuilder builder;
    const MeshBuilder::Corner a{{1, 0, 0}, {0.375f, 0.25f}}, b{{1, 1, 0}, {0.375f, 0.5f}};
    builder.quad({{0, 0, 0}, {0.125f, 0.25f}}, a, b, {{0, 1, 0}, {0.125f, 0.5f}});
    builder.quad({{1, 0, 0}, {0.625f, 0.25f}}, {{2, 0, 0}, {0.875f, 0.25f}}, {{2, 1, 0}, {0.875f, 0.5f}},
                 {{1, 1, 0}, {0.625f, 0.5f}});
    builder.triangle(a, b, a);
    EXPECT_EQ(gap_after_copies(builder.build(), 64, 64), 0);
}

TEST(Seam, slanted_and_scaled_seams_become_equations_that_cover_every_tap) {
    for (const auto& [turn, scale] : {std::pair{0.4, 1.0}, {0.0, 0.7}, {1.1, 0.45}, {0.785398, 1.0}}) {
        const Mesh mesh = cut_strip(turn, scale);
        const SeamTable table = build_seam_table(mesh, 64, 64, Wrap::repeat);
        expect_well_formed(table);
        // At least two a texel of the side with more texels.
        EXPECT_GE(table.equations.size(), 2 * 16u) << turn << ' ' << scale;
        EXPECT_FALSE(seam_gaps(mesh, HeightMap(64, 64), Wrap::repeat).front().aligned);
        EXPECT_EQ(max_seam_gap(mesh, HeightMap(64, 64, 777), Wrap::repeat, false), 0);
        EXPECT_EQ(max_seam_gap(mesh, random_map(64, 64, 1), Wrap::repeat, true), 0);
        EXPECT_GT(max_seam_gap(mesh, random_map(64, 64, 1), Wrap::repeat, false), 1000);
    }
}

TEST(Seam, equations_measure_the_gap_of_the_map) {
    const Mesh mesh = cut_strip(0.4, 0.8);
    const SeamTable table = build_seam_table(mesh, 64, 64, Wrap::repeat);
    HeightMap map = random_map(64, 64, 9);
    fill_gutters(map, table);
    double largest = 0;
    for (const SeamEquation& e : table.equations) {
        double sum = 0;
        for (std::size_t i = 0; i < 8; ++i)
            sum += static_cast<double>(e.weight[i]) * map.texels()[e.texel[i]];
        largest = std::max(largest, std::abs(sum));
    }
    const double gap = max_seam_gap(mesh, map, Wrap::repeat, false);
    EXPECT_LE(largest, gap * 1.0001);
    EXPECT_GE(largest, gap * 0.8);
}

TEST(Seam, islands_too_close_for_their_gutters_become_equations_not_wrong_copies) {
    // Two texels a 1/64: at 64 texels a side the islands' gaps shrink, but no owned texel may be overwritten.
    for (const int size : {16, 24, 32, 40, 64}) {
        const Mesh mesh = box_sphere(6, 6, 7, 2);
        const HeightMap map(size, size);
        const MeshSurface surface(mesh, displacement(0.1), map);
        expect_well_formed(surface.seams());
    }
}

TEST(Seam, a_map_of_one_texel_has_no_gap) {
    for (const Mesh& mesh : {plane(), box_sphere(2, 2, 2), cut_strip(0.4, 1), cut_cylinder(5)}) {
        const SeamTable table = build_seam_table(mesh, 1, 1, Wrap::repeat);
        EXPECT_TRUE(table.copies.empty());
        EXPECT_TRUE(table.equations.empty());
        EXPECT_EQ(max_seam_gap(mesh, HeightMap(1, 1, 4000), Wrap::repeat, false), 0);
    }
}

TEST(Seam, a_map_of_one_row_or_column) {
    for (const Mesh& mesh : {box_sphere(4, 4, 4, 1), cut_strip(0.4, 1), cut_cylinder(5)}) {
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
            expect_well_formed(build_seam_table(mesh, 1, 256, wrap));
            expect_well_formed(build_seam_table(mesh, 256, 1, wrap));
        }
    }
}

}  // namespace
}  // namespace relievo::seam_test
