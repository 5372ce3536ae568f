// The suite's own judges, fed with answers that are right, and wrong in every way. No device.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "renderer/stability/case_parts.h"
#include "renderer/stability/float_floor.h"
#include "renderer/stability/promises.h"
#include "renderer/stability/ray_judge.h"

namespace relievo::stability::judging_test {
namespace {

// What the reference says, as picks.
std::vector<PickHit> true_picks(const ReferenceSurface& surface, const std::vector<Ray>& rays) {
    std::vector<PickHit> picks;
    for (const Ray& ray : rays) {
        const auto hit = surface.first_hit(glm::dvec3(ray.origin), glm::dvec3(ray.direction), 0, 1e30);
        if (!hit) {
            picks.emplace_back();
            continue;
        }
        picks.push_back({true, hit->object, hit->face, static_cast<float>(hit->b1),
                         static_cast<float>(hit->b2), static_cast<float>(hit->t), glm::vec3(hit->position),
                         glm::vec3(hit->normal)});
    }
    return picks;
}

class RayJudging : public testing::Test {
  protected:
    RayJudging() : case_(on_plane(0.2, 0.5, dunes_map(64, 64))), surface_(case_.reference()) {
        RaySet set{"down", {}};
        for (int i = 0; i < 100; ++i)  // the last ten miss
            set.rays.push_back({{0.011f * static_cast<float>(i), 0.37f, 1}, {0.05f, 0.02f, -1}});
        judge_.emplace(case_, surface_, set);
        picks_ = true_picks(surface_, judge_->rays());
    }

    ImageComparison judged() const { return judge_->compare(picks_); }

    Case case_;
    ReferenceSurface surface_;
    std::optional<RayJudge> judge_;
    std::vector<PickHit> picks_;
};

TEST_F(RayJudging, TheReferencesOwnAnswersAreRight) {
    const ImageComparison errors = judged();
    EXPECT_GT(errors.both, 80);
    EXPECT_LT(errors.both, 100);
    EXPECT_TRUE(right_failures(errors).empty()) << right_failures(errors)[0];
}

TEST_F(RayJudging, AHitThatIsMissedCounts) {
    picks_[30] = {};
    const ImageComparison errors = judged();
    EXPECT_EQ(errors.missed, 1);
    EXPECT_EQ(errors.unexplained, 1);
    ASSERT_EQ(errors.unexplained_examples.size(), 1u);
    EXPECT_EQ(errors.unexplained_examples[0].x, 30);
    EXPECT_FALSE(right_failures(errors).empty());
}

TEST_F(RayJudging, AHitThatIsInventedCounts) {
    picks_[99] = picks_[10];
    EXPECT_EQ(judged().invented, 1);
}

TEST_F(RayJudging, AHitTooNearOrTooFarCounts) {
    picks_[30].distance += 0.01f;  // a twentieth of the amplitude
    picks_[40].distance -= 0.01f;
    EXPECT_EQ(judged().off, 2);
    EXPECT_EQ(judged().unexplained, 2);
}

TEST_F(RayJudging, ASlightlyShiftedHitIsInTheRanks) {
    for (PickHit& pick : picks_) pick.distance += 1e-4f;
    const ImageComparison errors = judged();
    EXPECT_EQ(errors.unexplained, 0);
    EXPECT_GT(errors.depth.median, 1e-4);
    EXPECT_FALSE(right_failures(errors).empty());
}

TEST_F(RayJudging, NumbersThatAreNoneCount) {
    picks_[3].distance = std::numeric_limits<float>::quiet_NaN();
    picks_[4].normal.x = std::numeric_limits<float>::infinity();
    EXPECT_EQ(judged().not_finite, 2);
}

TEST_F(RayJudging, NormalsThatAreTurnedCount) {
    for (PickHit& pick : picks_) pick.normal = glm::vec3(0.6f, 0, 0.8f);
    EXPECT_GT(judged().normal_deg.median, 10);
}

// A ray that starts on the surface, or lies in its border, may hit or miss.
TEST(RayJudge, RaysWithSeveralRightAnswersAcceptThemAll) {
    const Case c = on_plane(1, 0.5, flat_map(0, 1, 1));  // at z = -1/2
    const ReferenceSurface surface = c.reference();
    const RaySet set{
        "on", {{{0.4f, 0.3f, -0.5f}, {0, 0, 1}}, {{1, 0.3f, 1}, {0, 0, -1}}, {{-1, 0.3f, -0.5f}, {1, 0, 0}}}};
    const RayJudge judge(c, surface, set);
    const std::vector<PickHit> hits = true_picks(surface, judge.rays()), misses(3);
    EXPECT_TRUE(hits[0].hit && hits[1].hit && hits[2].hit);
    EXPECT_EQ(judge.compare(hits).unexplained, 0);
    EXPECT_EQ(judge.compare(misses).unexplained, 0);
    EXPECT_EQ(judge.compare(misses).silhouette_missed, 3);
    std::vector<PickHit> off = hits;
    off[0].distance = 0.05f;  // there is no surface
    EXPECT_EQ(judge.compare(off).unexplained, 1);
}

TEST(FloatUnits, AreTheAmplitudeUnlessFloatCannotTellIt) {
    const auto unit = [](double amplitude, double distance) {
        const Case c = on_plane(amplitude, 0.5, flat_map(0.5));
        return float_units(c, {0, 0, distance}, distance)[0].length;
    };
    EXPECT_EQ(unit(0.2, 2), 0.2);
    EXPECT_EQ(unit(-0.2, 2), 0.2);
    EXPECT_NEAR(unit(1e-6, 2), 0.0477, 1e-3);  // 1e-5 of it is two halves of the last place of 4
    EXPECT_NEAR(unit(0.2, 2e4), 477, 1);       // seen from far
    EXPECT_NEAR(unit(0, 1e-3), std::sqrt(0.5) / 100, 1e-6);  // none: by the size of the mesh
}

TEST(Promises, EveryLimitIsHeld) {
    ImageComparison good;
    EXPECT_TRUE(right_failures(good).empty());
    const auto breaks = [](auto change) {
        ImageComparison errors;
        change(errors);
        return right_failures(errors).size() == 1;
    };
    EXPECT_TRUE(breaks([](ImageComparison& e) { e.missed = 1; }));
    EXPECT_TRUE(breaks([](ImageComparison& e) { e.invented = 1; }));
    EXPECT_TRUE(breaks([](ImageComparison& e) { e.unexplained = 1; }));
    EXPECT_TRUE(breaks([](ImageComparison& e) { e.depth.median = 1.1e-5; }));
    EXPECT_TRUE(breaks([](ImageComparison& e) { e.depth_away.p99 = std::nan(""); }));
    EXPECT_TRUE(breaks([](ImageComparison& e) { e.normal_deg.median = 0.21; }));
    good.depth.median = 0.05;
    EXPECT_TRUE(sampled_failures(good, Sampled::no_promise).empty());
    EXPECT_TRUE(sampled_failures(good, Sampled::known_flaw).empty());
    EXPECT_EQ(sampled_failures(good, Sampled::within_limits).size(), 1u);
}

}  // namespace
}  // namespace relievo::stability::judging_test
