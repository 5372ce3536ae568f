// Strokes over the poles of a globe, where every island ends in a point: one height, and no line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "brushes/sculptor.h"
#include "editor/session/surface/mesh_surface.h"
#include "editor/session/surface/seam_gap.h"
#include "slope_jump.h"
#include "test_meshes.h"

namespace relievo::pole_test {
namespace {

using namespace test;

constexpr double kAmplitude = 0.2;

struct Outcome {
    double gap = 0, relief = 0;     // counts
    double greatest = 0, mean = 0;  // jump of slope over seams
};

// Dabs in a row through two places near the north pole.
Outcome stroke(const Mesh& mesh, int size, Tool tool, glm::dvec2 from, glm::dvec2 to,
               Wrap wrap = Wrap::repeat) {
    HeightMap map(size, size);
    const Displacement d = displacement(kAmplitude, 0.5, wrap);
    const MeshSurface surface(mesh, d, map);
    Sculptor sculptor(map, surface);
    Brush brush;
    brush.tool = tool;
    brush.radius = 0.15f;
    sculptor.begin(brush);
    constexpr int kDabs = 40;
    for (int i = 0; i <= kDabs; ++i) {
        const glm::dvec2 at = from + (to - from) * (static_cast<double>(i) / kDabs);
        const FacePoint point = surface.nearest_on_base(glm::normalize(glm::dvec3(at.x, 1, at.y)));
        Dab dab;
        dab.face = point.face, dab.b1 = point.b1, dab.b2 = point.b2;
        sculptor.dab(dab);
    }
    sculptor.end();
    Outcome outcome;
    const auto [low, high] = std::minmax_element(map.texels().begin(), map.texels().end());
    outcome.relief = *high - *low;
    outcome.gap = max_seam_gap(mesh, map, wrap, false);
    double seams = 0;
    for (const SlopeJump& jump : slope_jumps(mesh, map, d)) {
        if (!jump.seam || jump.aligned) continue;
        outcome.greatest = std::max(outcome.greatest, jump.greatest);
        outcome.mean += jump.mean, ++seams;
    }
    outcome.mean /= std::max(seams, 1.0);
    return outcome;
}

TEST(Pole, a_stroke_over_it_or_beside_it_leaves_no_line) {
    for (const auto& [around, along] : {std::pair(32, 16), std::pair(64, 24)})
        for (const double beside : {0.0, 0.05}) {
            const Outcome outcome =
                stroke(globe(around, along), 1024, Tool::draw, {-0.45, beside}, {0.45, beside + 0.1});
            EXPECT_GT(outcome.relief, 8000);
            EXPECT_LT(outcome.gap, 0.001 * outcome.relief) << around << ' ' << beside;
            EXPECT_LT(outcome.greatest, 0.1) << around << ' ' << beside;
            EXPECT_LT(outcome.mean, 0.002) << around << ' ' << beside;
        }
}

TEST(Pole, coarse_maps_and_single_texels_end_in_heights_all_the_same) {
    for (const int size : {1, 2, 7, 32, 100})
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
            const Outcome outcome = stroke(globe(32, 16), size, Tool::draw, {-0.4, 0}, {0.4, 0}, wrap);
            EXPECT_LE(outcome.gap, outcome.relief);
        }
}

TEST(Pole, what_texels_beyond_the_seams_hold_are_means_of_owned_ones) {
    for (const int size : {8, 64, 256}) {
        const HeightMap map(size, size);
        const Mesh mesh = globe(32, 16);
        const MeshSurface surface(mesh, displacement(kAmplitude), map);
        for (const SeamExtension& extension : surface.seams().extensions) {
            double sum = 0;
            for (const SeamExtension::Source& source : extension.sources) {
                const auto x = static_cast<int>(source.texel) % size,
                           y = static_cast<int>(source.texel) / size;
                EXPECT_TRUE(surface.owned(x, y));
                sum += static_cast<double>(source.weight);
            }
            EXPECT_NEAR(sum, 1, 1e-4);
        }
    }
}

// A pole with a hole beside it: the faces do not close.
TEST(Pole, an_open_fan_is_left_to_its_seams) {
    MeshBuilder builder;
    for (int i = 0; i < 9; ++i) {
        const auto spoke = [](int k) {
            const float angle = 0.6f * static_cast<float>(k);
            return glm::vec3(std::cos(angle), 0, std::sin(angle));
        };
        const float u = 0.1f * static_cast<float>(i);
        builder.triangle({spoke(i), {u + 0.01f, 0.2f}}, {{0, 0.2f, 0}, {u + 0.05f, 0.7f}},
                         {spoke(i + 1), {u + 0.09f, 0.2f}});
    }
    const Mesh mesh = builder.build();
    const Outcome outcome = stroke(mesh, 256, Tool::draw, {-0.2, 0.3}, {0.3, -0.1});
    EXPECT_GT(outcome.relief, 1000);
    EXPECT_LT(outcome.gap, 0.05 * outcome.relief);
}

}  // namespace
}  // namespace relievo::pole_test
