// What is drawn from measured points: which are tried, which is the most exact, and how times compare at
// equal error.
#include "editor/session/compare/answers.h"

#include <gtest/gtest.h>

#include <set>

#include "editor/session/compare/error_map.h"
#include "editor/session/compare/image_error.h"
#include "editor/session/compare/points.h"

namespace relievo::answers_test {
namespace {

ComparedPoint point(const std::string& method, double value, double p99, double p999,
                    std::vector<double> times) {
    ComparedPoint p;
    p.method = method;
    p.label = method + " dt " + swept_text(value);
    p.errors.both = 1000;
    p.errors.depth.p99 = p99;
    p.errors.depth.p999 = p999;
    p.primary.wall = p.preview.wall = std::move(times);
    return p;
}

TEST(Points, EveryMethodIsTriedAndEveryValueThatItsDescriptionSweeps) {
    std::vector<std::string> names;
    std::size_t expected = 0;
    for (const Method* method : methods()) {
        names.emplace_back(method->name);
        std::size_t count = 1;
        for (const MethodParameter& p : method->parameters) {
            if (!p.sweep.empty()) count *= p.sweep.size();
            for (const double value : p.sweep) EXPECT_TRUE(value >= p.low && value <= p.high) << p.name;
        }
        expected += count;
    }
    const std::vector<PointChoice> points = comparison_points(names);
    EXPECT_EQ(points.size(), expected);
    for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(points[i].method->name, names[i]);
    EXPECT_EQ(comparison_points({"pdm"}).front().label, "pdm dt 0.02");
    EXPECT_EQ(comparison_points({"exact"}).front().label, "exact");
    EXPECT_EQ(comparison_points({"dbvh"}).front().label, "dbvh leaf box level 3");
}

TEST(Points, OverAProceduralSourceDbvhIsSweptByRange) {
    std::set<double> ranges;
    for (const PointChoice& point : comparison_points({"dbvh"}, true)) {
        EXPECT_FALSE(point.swept.contains("level"));
        ranges.insert(point.swept.at("range"));
    }
    EXPECT_EQ(ranges, (std::set<double>{0, 8, 16, 64, 128, 256, 512}));
    for (const PointChoice& point : comparison_points({"dbvh"})) EXPECT_FALSE(point.swept.contains("range"));
    EXPECT_EQ(comparison_points({"march"}, true).size(), comparison_points({"march"}).size());
}

TEST(Points, AreOfOneLineWhereOnlyTheLastSweptParameterDiffers) {
    EXPECT_EQ(swept_line("dbvh", {{"leaf", 1}, {"level", 3}}), "triangles ");
    EXPECT_EQ(swept_line("dbvh", {{"leaf", 1}, {"level", 2}}), "triangles ");
    EXPECT_NE(swept_line("dbvh", {{"leaf", 2}, {"level", 2}}), "triangles ");
    EXPECT_EQ(swept_line("pdm", {{"dt", 0.01}}), "");
    EXPECT_EQ(swept_line("exact", {}), "");
    EXPECT_EQ(swept_line("unknown", {{"dt", 0.01}}), "");
    EXPECT_EQ(swept_text("dbvh", "leaf", 2), "bilinear");
    EXPECT_EQ(swept_text("dbvh", "range", 64), "64");
}

TEST(Answers, ComparesTimesAtEqualErrorByRounds) {
    ComparedScene scene;
    scene.points = {point("exact", 0, 1e-6, 1e-5, {10, 30, 20}), point("pdm", 0.02, 0.1, 0.5, {5, 15, 10}),
                    point("pdm", 0.01, 5e-4, 1e-2, {8, 20, 16}),
                    point("pdm", 0.005, 1e-4, 9e-4, {20, 60, 40}), point("pdm", 0.002, 1e-5, 1e-4, {})};
    answer_speed(scene);
    ASSERT_EQ(scene.answers.size(), 1u);
    const SpeedAnswer& answer = scene.answers.front();
    EXPECT_EQ(answer.subject, "exact dt 0");
    EXPECT_EQ(answer.method, "pdm");
    EXPECT_EQ(answer.at_p99.label, "pdm dt 0.01");
    EXPECT_DOUBLE_EQ(answer.at_p99.primary, 1.25);  // median of 1.25, 1.5, 1.25
    EXPECT_EQ(answer.at_p999.label, "pdm dt 0.005");
    EXPECT_DOUBLE_EQ(answer.at_p999.primary, 0.5);
    EXPECT_EQ(answer.best.label, "pdm dt 0.002");
    EXPECT_EQ(answer.best.primary, 0);  // not timed
}

TEST(Answers, SayWhenNoSettingKeepsTheError) {
    ComparedScene scene;
    scene.points = {point("exact", 0, 1e-6, 1e-5, {10}), point("pdm", 0.02, 0.1, 0.5, {5})};
    answer_speed(scene);
    EXPECT_EQ(scene.answers.front().at_p999.label, "");
    EXPECT_EQ(scene.answers.front().best.label, "pdm dt 0.02");
}

TEST(Answers, WrongPixelsCountBeforeDepth) {
    std::vector<ComparedPoint> points{point("a", 1, 1e-7, 1e-7, {}), point("b", 1, 1e-4, 1e-4, {}),
                                      point("c", 1, 1e-5, 1e-5, {})};
    points[0].errors.missed = 5;  // of 1000
    EXPECT_EQ(most_exact_point(points), 2u);
}

TEST(BestFront, HoldsWhatNoOtherBeatsInBoth) {
    const std::vector<FrontPoint> points{{3, 1}, {1, 10}, {2, 20}, {2, 5}, {4, 1}, {5, 0.5}};
    EXPECT_EQ(best_front(points), (std::vector<std::size_t>{1, 3, 0, 5}));
    EXPECT_TRUE(best_front({}).empty());
}

TEST(Spreads, AreTakenBetweenRanks) {
    const Spread spread = spread_of({5, 1, 3, 2, 4, 6, 7, 8, 9, 10, 11});
    EXPECT_DOUBLE_EQ(spread.median, 6);
    EXPECT_DOUBLE_EQ(spread.p10, 2);
    EXPECT_DOUBLE_EQ(spread.p90, 10);
    EXPECT_DOUBLE_EQ(spread_of({4, 2}).median, 3);
    EXPECT_EQ(spread_of({}).median, 0);
}

TEST(ImageErrors, OfKnownImages) {
    constexpr int kSize = 64;
    std::vector<float> truth(kSize * kSize * 4, 0.5f), other = truth;
    EXPECT_EQ(image_error(kSize, kSize, other, truth).rmse, 0);
    EXPECT_LT(image_error(kSize, kSize, other, truth).dissimilarity, 1e-12);
    for (int y = 16; y < 48; ++y)
        for (int x = 16; x < 48; ++x)
            for (int c = 0; c < 3; ++c) other[static_cast<std::size_t>((y * kSize + x) * 4 + c)] = 0.9f;
    const ImageError error = image_error(kSize, kSize, other, truth);
    EXPECT_NEAR(error.rmse, 0.2, 1e-6);    // 0.4 on a quarter of the pixels
    EXPECT_GT(error.dissimilarity, 0.05);  // brightness alone
    EXPECT_LT(error.dissimilarity, 0.5);
}

TEST(ErrorMaps, MarkWhatIsMissedAndInvented) {
    using Error = Judge::PixelError;
    const DisplayPicture picture = error_map(4, 1,
                                             {{Error::Kind::nothing, 0},
                                              {Error::Kind::missed, 0},
                                              {Error::Kind::invented, 0},
                                              {Error::Kind::both, 1e-3f}});
    const auto color = [&](std::size_t i) {
        return Rgb{picture.rgba[4 * i], picture.rgba[4 * i + 1], picture.rgba[4 * i + 2]};
    };
    EXPECT_EQ(color(0), kNothingColor);
    EXPECT_EQ(color(1), kMissedColor);
    EXPECT_EQ(color(2), kInventedColor);
    EXPECT_EQ(color(3), error_color(1e-3));
    EXPECT_EQ(error_color(0), error_color(kErrorMapLow));
    EXPECT_EQ(error_color(1e9), error_color(kErrorMapHigh));
    EXPECT_NE(error_color(1e-5), error_color(1e-4));
}

}  // namespace
}  // namespace relievo::answers_test
