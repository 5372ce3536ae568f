// The judge on images whose errors are known: two flat squares, one object each, with a gap between them.
#include "renderer/judge/judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/reference/sample_surfaces.h"

namespace relievo::test::judge_test {
namespace {

constexpr int kSize = 40;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

class JudgeOfTwoSquares : public testing::Test {
  protected:
    JudgeOfTwoSquares()
        : left_(square(-1.2f, 0.2)),
          right_(square(0.2f, 0.01)),
          surface_(reference_of()),
          judge_(judge_of()) {
        depth_.assign(judge_.image().depth.begin(), judge_.image().depth.end());
        for (const glm::dvec3& n : judge_.image().normal)
            for (int k = 0; k < 3; ++k) normal_.push_back(static_cast<float>(n[k]));
    }

    static SampleSurface square(float shift, double amplitude) {
        SampleSurface s;
        s.mesh = plane_mesh();
        for (glm::vec3& p : s.mesh.positions) p.x += shift;
        s.amplitude = amplitude;
        s.midlevel = 0.5;
        return s;
    }
    ReferenceSurface reference_of() const {
        const ReferenceObject objects[] = {left_.object(), right_.object()};
        return ReferenceSurface(objects);
    }
    Judge judge_of() const {
        const Camera camera{{0, 0.5, 3}, {0, 0.5, 0}, {0, 1, 0}, 45};
        const ErrorUnit units[] = {error_unit(left_.amplitude, left_.mesh),
                                   error_unit(right_.amplitude, right_.mesh)};
        return Judge(trace_image(surface_, camera, glm::dvec3(0), kSize, kSize), camera, glm::dvec3(0),
                     units);
    }

    std::size_t pixel(int x, int y) const { return static_cast<std::size_t>(y * kSize + x); }
    ImageComparison compare() const { return judge_.compare(depth_, normal_); }

    SampleSurface left_, right_;
    ReferenceSurface surface_;
    Judge judge_;
    std::vector<float> depth_, normal_;
    const std::size_t in_left_ = pixel(10, 20), in_right_ = pixel(29, 20), in_gap_ = pixel(19, 20);
};

TEST_F(JudgeOfTwoSquares, AnEqualImageHasNoErrors) {
    const ImageComparison result = compare();
    EXPECT_GT(result.both, 300);
    EXPECT_EQ(judge_.image().object[in_left_], 1u);
    EXPECT_EQ(judge_.image().object[in_right_], 2u);
    EXPECT_EQ(judge_.image().object[in_gap_], 0u);
    EXPECT_EQ(result.missed + result.invented + result.silhouette_missed + result.silhouette_invented, 0);
    EXPECT_EQ(result.not_finite, 0);
    EXPECT_LT(result.depth.most, 1e-4);
    EXPECT_LT(result.normal_deg.most, 0.1);
    EXPECT_TRUE(result.examples.empty());
}

TEST_F(JudgeOfTwoSquares, MissedAndInventedAreCountedAwayFromSilhouettesAndAtThem) {
    depth_[in_left_] = kInfinity;
    depth_[pixel(0, 0)] = 3;
    std::size_t edge = in_left_;  // the last hit before the gap
    while (judge_.image().object[edge + 1] != 0) ++edge;
    depth_[edge] = kInfinity;
    depth_[edge + 1] = 3;
    const ImageComparison result = compare();
    EXPECT_EQ(result.missed, 1);
    EXPECT_EQ(result.invented, 1);
    EXPECT_EQ(result.silhouette_missed, 1);
    EXPECT_EQ(result.silhouette_invented, 1);
    ASSERT_EQ(result.examples.size(), 2u);
    EXPECT_EQ(result.examples[0].kind, OffPixel::Kind::invented);
    EXPECT_EQ(result.examples[1].kind, OffPixel::Kind::missed);
    EXPECT_EQ(result.examples[1].x, 10);
}

TEST_F(JudgeOfTwoSquares, DepthIsToldInTheAmplitudeOfTheObjectThatIsHit) {
    depth_[in_left_] += 0.02f;   // a tenth of 0.2
    depth_[in_right_] += 0.02f;  // twice 0.01
    EXPECT_NEAR(compare().depth.most, 2, 1e-3);
    EXPECT_EQ(compare().off, 2);
    depth_[in_right_] -= 0.02f;
    EXPECT_NEAR(compare().depth.most, 0.1, 1e-3);
    EXPECT_EQ(compare().off, 1);
}

TEST_F(JudgeOfTwoSquares, NormalsAndAnglesAreTold) {
    normal_[3 * in_left_] = std::sin(0.1f);
    normal_[3 * in_left_ + 2] = std::cos(0.1f);
    EXPECT_NEAR(compare().normal_deg.most, 5.7296, 1e-3);
    const ImageComparison result = compare();
    const auto& facing = result.by_angle[static_cast<std::size_t>(ViewAngle::facing)];
    EXPECT_EQ(facing.both, result.both);  // the camera looks straight at the squares
    EXPECT_NEAR(facing.normal_deg.most, 5.7296, 1e-3);
    EXPECT_EQ(result.by_angle[static_cast<std::size_t>(ViewAngle::grazing)].both, 0);
}

TEST_F(JudgeOfTwoSquares, WhatIsNotFiniteIsCounted) {
    depth_[in_left_] = std::numeric_limits<float>::quiet_NaN();
    depth_[in_gap_] = -kInfinity;
    normal_[3 * in_right_] = std::numeric_limits<float>::quiet_NaN();
    const ImageComparison result = compare();
    EXPECT_EQ(result.not_finite, 3);
    EXPECT_EQ(result.missed, 1);
    EXPECT_EQ(result.normal_deg.most, 180);
}

TEST_F(JudgeOfTwoSquares, OnlyRaysThroughTheOutlineExplainAMiss) {
    depth_[in_left_] = kInfinity;
    depth_[in_right_] += 0.02f;
    ImageComparison result = compare();
    judge_.count_unexplained(surface_, depth_, result);
    EXPECT_EQ(result.unexplained, 2);
    ASSERT_EQ(result.unexplained_examples.size(), 2u);
    EXPECT_EQ(result.unexplained_examples[0].kind, OffPixel::Kind::missed);
    EXPECT_EQ(result.unexplained_examples[1].kind, OffPixel::Kind::depth);
}

TEST_F(JudgeOfTwoSquares, ManyWrongPixelsAreEstimated) {
    std::fill(depth_.begin(), depth_.end(), kInfinity);
    ImageComparison result = compare();
    judge_.count_unexplained(surface_, depth_, result, 20);
    const int hits = result.missed + result.silhouette_missed;
    EXPECT_EQ(result.unexplained, hits);
}

TEST_F(JudgeOfTwoSquares, ErrorMapMarksEveryPixel) {
    depth_[in_left_] = kInfinity;
    depth_[in_gap_] = 3;
    depth_[in_right_] += 0.02f;
    const auto errors = judge_.errors(depth_);
    using Kind = Judge::PixelError::Kind;
    EXPECT_EQ(errors[in_left_].kind, Kind::missed);
    EXPECT_EQ(errors[in_gap_].kind, Kind::invented);
    EXPECT_EQ(errors[in_right_].kind, Kind::both);
    EXPECT_NEAR(errors[in_right_].depth, 2, 1e-3);
    EXPECT_EQ(errors[pixel(0, 0)].kind, Kind::nothing);
}

// One pixel over the border of a square, from so near that turning the ray moves it less than floats can
// tell.
int unexplained_beyond_the_border(double beyond) {
    SampleSurface square;
    square.mesh = plane_mesh();
    square.amplitude = 0;
    const ReferenceObject object = square.object();
    const ReferenceSurface surface({&object, 1});
    const Camera camera{{1 + beyond, 0.5, 1e-5}, {1 + beyond, 0.5, 0}, {0, 1, 0}, 45};
    const ErrorUnit unit = error_unit(square.amplitude, square.mesh);
    const Judge judge(trace_image(surface, camera, glm::dvec3(0), 1, 1), camera, glm::dvec3(0), {&unit, 1});
    EXPECT_FALSE(std::isfinite(judge.image().depth[0]));
    const float method = 1e-5f;
    ImageComparison result;
    judge.count_unexplained(surface, {&method, 1}, result);
    return result.unexplained;
}

TEST(JudgeNearTheSurface, WhatTheEyesOwnRoundingMovesIsExplainedAndNoMore) {
    EXPECT_EQ(unexplained_beyond_the_border(5e-8), 0);
    EXPECT_EQ(unexplained_beyond_the_border(3e-7), 1);
}

TEST(ErrorUnits, WithoutAmplitudeTheRadiusServes) {
    const Mesh mesh = plane_mesh();
    EXPECT_EQ(error_unit(-0.3, mesh).length, 0.3);
    EXPECT_TRUE(error_unit(-0.3, mesh).is_amplitude);
    const ErrorUnit unit = error_unit(0, mesh);
    EXPECT_FALSE(unit.is_amplitude);
    EXPECT_NEAR(unit.length, std::sqrt(0.5) / 100, 1e-7);
    EXPECT_EQ(unit.name(), "radius / 100");
}

TEST(ErrorRanksOf, AHundredErrors) {
    std::vector<double> errors;
    for (int i = 0; i <= 1000; ++i) errors.push_back(1000 - i);
    const ErrorRanks ranks = rank_errors(errors);
    EXPECT_EQ(ranks.median, 500);
    EXPECT_EQ(ranks.p99, 990);
    EXPECT_EQ(ranks.p999, 999);
    EXPECT_EQ(ranks.most, 1000);
    EXPECT_EQ(rank_errors({}).most, 0);
}

}  // namespace
}  // namespace relievo::test::judge_test
