// Where the stamps of a gesture lie: upright in the picture or along the stroke, the same at any frame rate.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "editor/session/stroke_input.h"

namespace relievo::stamp_input_test {
namespace {

constexpr double kPixelsPerUnit = 100;

// Parallel rays down on the square [0, 8] x [0, 8] of the plane z = 0, with a gap where `gap` says so; the
// picture's right is x.
struct Table {
    std::vector<Dab> dabs;
    std::function<bool(double x)> gap = [](double) { return false; };

    StrokeInput input(const StrokeSettings& settings, float spacing = 1.0f) {
        Brush brush;
        brush.tool = Tool::stamp;
        brush.radius = 0.5f;
        brush.spacing = 0.02f;
        brush.stamp_spacing = spacing;
        return StrokeInput(
            brush,
            [this](std::span<const Ray> rays) {
                std::vector<PickHit> hits;
                for (const Ray& ray : rays) {
                    PickHit hit;
                    hit.position = {ray.origin.x, ray.origin.y, 0};
                    hit.hit = hit.position.x >= 0 && hit.position.x <= 8 && !gap(double{hit.position.x});
                    hit.b1 = ray.origin.x / 16, hit.b2 = ray.origin.y / 16;
                    hit.distance = 10;
                    hit.normal = {0, 0, 1};
                    hits.push_back(hit);
                }
                return hits;
            },
            [](double x, double y) {
                const glm::vec3 target(static_cast<float>(x / kPixelsPerUnit),
                                       static_cast<float>(y / kPixelsPerUnit), 0);
                return Ray{target + glm::vec3(0, 0, 10), {target.x * 0.01f, target.y * 0.01f, -1}};
            },
            [this](const Dab& dab) { dabs.push_back(dab); }, settings);
    }

    double degrees(std::size_t i) const {
        return std::atan2(dabs[i].drag[1], dabs[i].drag[0]) * 180 / 3.14159265358979323846;
    }
    glm::dvec2 place(std::size_t i) const {
        return glm::dvec2(dabs[i].b1, dabs[i].b2) * (16.0 / Dab::kBarycentricOne);
    }
};

StrokeSettings along() {
    StrokeSettings settings;
    settings.along_stroke = true;
    return settings;
}

TEST(StampInput, UprightStampsLieAlongThePicturesRightWhereverTheStrokeGoes) {
    Table table;
    StrokeInput input = table.input({});
    input.begin({0, 100, 100, 1});
    EXPECT_EQ(table.dabs.size(), 1u) << "at once";
    input.end({1000, 300, 500, 1});
    ASSERT_EQ(table.dabs.size(), 9u) << "a stamp every radius of 4.47 units";
    for (std::size_t i = 0; i < table.dabs.size(); ++i) EXPECT_NEAR(table.degrees(i), 0, 0.5);
}

TEST(StampInput, AlongTheStrokeEveryStampLiesAsTheStrokeGoesTheFirstTooAndStartsWhereThePressWas) {
    Table table;
    StrokeInput input = table.input(along());
    input.begin({0, 100, 100, 1});
    EXPECT_TRUE(table.dabs.empty()) << "no direction yet";
    for (std::uint64_t i = 1; i <= 100; ++i)
        input.move({i * 1000, 100 + 3.0 * static_cast<double>(i), 100 + 4.0 * static_cast<double>(i), 1});
    input.end({200000, 400, 500, 1});
    ASSERT_EQ(table.dabs.size(), 11u);
    for (std::size_t i = 0; i < table.dabs.size(); ++i) EXPECT_NEAR(table.degrees(i), 53.13, 0.1) << i;
    EXPECT_NEAR(table.place(0).x, 1, 1e-4);
    EXPECT_EQ(table.dabs[0].time_us, 0u);
    for (const Dab& dab : table.dabs)
        EXPECT_NEAR(std::hypot(dab.drag[0], dab.drag[1]), Dab::kDragOne, 2) << "a unit direction";
}

TEST(StampInput, ACircleTurnsTheStampsEvenlyThoughEventsLieOnWholePixels) {
    Table table;
    StrokeInput input = table.input(along(), 0.25f);
    const auto at = [](double angle) {
        return PointerEvent{static_cast<std::uint64_t>(angle * 1e6), std::round(400 + 200 * std::cos(angle)),
                            std::round(400 + 200 * std::sin(angle)), 1};
    };
    input.begin(at(0));
    for (double angle = 0.01; angle < 3.1; angle += 0.01) input.move(at(angle));
    input.end(at(3.1));
    ASSERT_GT(table.dabs.size(), 45u);
    for (std::size_t i = 10; i < table.dabs.size(); ++i) {  // once the lag has settled
        const glm::dvec2 out = table.place(i) - glm::dvec2(4);
        const double tangent = std::atan2(out.x, -out.y) * 180 / 3.14159265358979323846;
        const double lag =
            std::asin(0.25 / 2) * 180 / 3.14159265358979323846;  // of a toy on a string of 0.25
        EXPECT_NEAR(std::remainder(tangent - table.degrees(i), 360), lag, 1.5) << i;
    }
}

TEST(StampInput, AClickAloneStampsUprightAtItsEnd) {
    Table table;
    StrokeInput input = table.input(along());
    input.begin({0, 100, 100, 1});
    input.end({1000, 100, 100, 1});
    ASSERT_EQ(table.dabs.size(), 1u);
    EXPECT_NEAR(table.degrees(0), 0, 0.5);
}

TEST(StampInput, BehindAGapTheFirstStampWaitsForItsOwnDirection) {
    Table table;
    table.gap = [](double x) { return x > 2 && x < 4; };
    StrokeInput input = table.input(along());
    input.begin({0, 150, 100, 1});
    input.move({1000, 300, 100, 1});  // into the gap
    input.move({2000, 402, 100, 1});
    input.end({3000, 402, 300, 1});  // straight up behind it
    ASSERT_GE(table.dabs.size(), 5u);
    std::size_t behind = 0;
    for (std::size_t i = 0; i < table.dabs.size(); ++i)
        if (table.place(i).x > 3) {
            EXPECT_NEAR(table.degrees(i), 90, 30) << i;
            ++behind;
        } else {
            EXPECT_NEAR(table.degrees(i), 0, 1) << i;
        }
    EXPECT_GE(behind, 4u);
}

TEST(StampInput, BatchesOfEventsDoNotMatterAndJitterComesFromTheSeed) {
    std::vector<PointerEvent> events{{0, 100, 300, 1}};
    for (int i = 1; i < 200; ++i)
        events.push_back(
            {static_cast<std::uint64_t>(i) * 3000, 100 + 3.0 * i, 300 + 60 * std::sin(0.07 * i), 1});
    StrokeSettings settings = along();
    settings.rotation_jitter = 40;
    const auto run = [&](std::uint32_t seed) {
        settings.seed = seed;
        Table table;
        StrokeInput input = table.input(settings, 0.5f);
        input.begin(events.front());
        for (const PointerEvent& event : events) input.move(event);
        input.end(events.back());
        return table.dabs;
    };
    EXPECT_EQ(run(1), run(1));
    EXPECT_NE(run(1), run(2));
    Table straight, jittered;
    settings.along_stroke = false;
    for (Table* table : {&straight, &jittered}) {
        settings.rotation_jitter = table == &straight ? 0.0f : 40.0f;
        StrokeInput input = table->input(settings, 0.5f);
        input.begin(events.front());
        for (const PointerEvent& event : events) input.move(event);
        input.end(events.back());
    }
    ASSERT_EQ(straight.dabs.size(), jittered.dabs.size());
    double most = 0;
    for (std::size_t i = 0; i < straight.dabs.size(); ++i)
        most = std::max(most, std::abs(straight.degrees(i) - jittered.degrees(i)));
    EXPECT_LE(most, 40.1);
    EXPECT_GT(most, 15);
}

TEST(StampInput, AnAirbrushStampsByTimeAlongTheStroke) {
    Table table;
    StrokeSettings settings = along();
    settings.rate = 10;
    StrokeInput input = table.input(settings);
    input.begin({0, 100, 100, 1});
    input.move({50000, 100, 200, 1});
    ASSERT_EQ(table.dabs.size(), 1u) << "it has a direction now";
    EXPECT_NEAR(table.degrees(0), 90, 0.5);
    input.end({350000, 100, 300, 1});
    EXPECT_EQ(table.dabs.size(), 4u);
    EXPECT_NEAR(table.degrees(3), 90, 0.5);
}

}  // namespace
}  // namespace relievo::stamp_input_test
