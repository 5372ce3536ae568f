// Dabs from pointer events: spaced by arc length, whatever the batches in which events arrive.
#include "editor/session/stroke_input.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <tuple>
#include <utility>

namespace relievo::stroke_input_test {
namespace {

constexpr float kPixelsPerUnit = 100;

// Parallel rays down on the square [0, 8] x [0, 8]; its height may depend on the place and on the dabs so
// far. A hit's barycentrics carry x / 8 and y / 8 halved, so that dabs can be read back.
class Sheet {
  public:
    std::function<float(float x, float y, std::size_t dabs)> height = [](float, float, std::size_t) {
        return 0.0f;
    };
    std::function<bool(float x, float y)> exists = [](float x, float y) {
        return x >= 0 && x <= 8 && y >= 0 && y <= 8;
    };
    std::vector<Dab> dabs;
    std::size_t picks = 0;

    StrokeInput input(float radius, float spacing, const StrokeSettings& settings = {},
                      StrokeInput::GoOn go_on = {}, Tool tool = Tool::draw) {
        Brush brush;
        brush.tool = tool;
        brush.radius = radius;
        brush.spacing = brush.stamp_spacing = spacing;
        return StrokeInput(
            brush, [this](std::span<const Ray> rays) { return pick(rays); },
            [](double x, double y) {
                // A distant eye: near enough to parallel, with directions that differ from pixel to pixel.
                const glm::vec3 target(static_cast<float>(x) / kPixelsPerUnit,
                                       static_cast<float>(y) / kPixelsPerUnit, 0);
                return Ray{target + glm::vec3(0, 0, 10), {target.x * 0.01f, target.y * 0.01f, -1}};
            },
            [this](const Dab& dab) { dabs.push_back(dab); }, settings, std::move(go_on));
    }

    static glm::dvec2 place(const Dab& dab) {
        return glm::dvec2(dab.b1, dab.b2) * (16.0 / Dab::kBarycentricOne);
    }

  private:
    std::vector<PickHit> pick(std::span<const Ray> rays) {
        ++picks;
        std::vector<PickHit> hits;
        for (const Ray& ray : rays) {
            PickHit hit;
            const float x = ray.origin.x, y = ray.origin.y;
            hit.hit = exists(x, y);
            hit.b1 = x / 16;
            hit.b2 = y / 16;
            hit.position = {x, y, height(x, y, dabs.size())};
            hit.distance = 10 - hit.position.z;
            hits.push_back(hit);
        }
        return hits;
    }
};

std::vector<PointerEvent> wild_path(unsigned seed, int count) {
    std::mt19937 random(seed);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    std::vector<PointerEvent> events{{1000000, 100, 400, 0.5}};
    for (int i = 1; i < count; ++i) {
        const PointerEvent& last = events.back();
        events.push_back({last.time_us + 1000 + random() % 7000, last.x_px + unit() * 12 - 3,
                          last.y_px + unit() * 16 - 8, unit()});
    }
    return events;
}

// The window's loop: events pile up and are handed over once a frame, whose length also shifts the other
// work.
std::vector<Dab> sculpt_at(double frames_per_second, const std::vector<PointerEvent>& events) {
    Sheet sheet;
    sheet.height = [](float x, float y, std::size_t dabs) {  // rises under the brush, as a drawn surface does
        return 0.2f * std::sin(3 * x) * std::cos(2 * y) + 0.01f * static_cast<float>(dabs);
    };
    StrokeInput input = sheet.input(0.2f, 0.15f);
    std::size_t next = 0;
    const double start = static_cast<double>(events.front().time_us);
    for (double frame = 1; next < events.size(); ++frame) {
        const double now = start + frame * 1e6 / frames_per_second;
        for (; next < events.size() && static_cast<double>(events[next].time_us) <= now; ++next) {
            if (next == 0)
                input.begin(events[next]);
            else if (next + 1 == events.size())
                input.end(events[next]);
            else
                input.move(events[next]);
        }
    }
    return sheet.dabs;
}

TEST(StrokeInput, FiveAndSixtyFramesASecondGiveTheSameDabs) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const auto events = wild_path(seed, 200);
        const auto slow = sculpt_at(5, events), fast = sculpt_at(60, events);
        EXPECT_GT(slow.size(), 50u);
        EXPECT_EQ(slow, fast) << seed;
    }
}

// One dab a call, as in a window whose every dab takes longer than its turn.
TEST(StrokeInput, WorkThatIsCutShortGoesOnToTheSameDabs) {
    StrokeSettings airbrush, trail;
    airbrush.rate = 200;
    airbrush.lazy_px = 5;
    trail.along_stroke = true;
    trail.jitter = 0.3f;
    StrokeSettings both = trail;
    both.rate = 200;
    const std::tuple<Tool, StrokeSettings> kinds[] = {{Tool::draw, {}},
                                                      {Tool::draw, airbrush},
                                                      {Tool::stamp, trail},
                                                      {Tool::stamp, both},
                                                      {Tool::grab, {}}};
    for (const auto& [tool, settings] : kinds)
        for (unsigned seed = 0; seed < 10; ++seed) {
            auto events = wild_path(seed, 60);
            for (PointerEvent& event : events) event.time_us *= 4;
            std::vector<Dab> expected;
            for (const bool cut_short : {false, true}) {
                Sheet sheet;
                sheet.height = [](float x, float y, std::size_t dabs) {
                    return 0.2f * std::sin(3 * x) * std::cos(2 * y) + 0.01f * static_cast<float>(dabs);
                };
                sheet.exists = [](float x, float) { return x < 2 || x > 2.5f; };
                StrokeInput input = sheet.input(
                    0.2f, 0.02f, settings, [&] { return !cut_short; }, tool);
                std::size_t waits = 0, before = 0;
                const auto finish = [&] {
                    for (; input.busy(); ++waits, before = sheet.dabs.size()) {
                        EXPECT_LE(sheet.dabs.size(), before + 1);
                        input.work();
                    }
                    before = sheet.dabs.size();
                };
                for (std::size_t i = 0; i < events.size(); ++i) {
                    if (i == 0)
                        input.begin(events[i]);
                    else if (i + 1 == events.size())
                        input.end(events[i]);
                    else if (i % 5 == 0)
                        input.rest(events[i].time_us);
                    else
                        input.move(events[i]);
                    finish();
                }
                if (!cut_short) expected = sheet.dabs;
                EXPECT_EQ(sheet.dabs, expected) << seed;
                EXPECT_EQ(waits > 0, cut_short && tool != Tool::grab) << seed;
            }
        }
}

TEST(StrokeInput, DabsAreSpacedByArcLengthAtAnyMouseSpeed) {
    for (double step_px : {0.3, 2.0, 7.7, 500.0}) {
        Sheet sheet;
        StrokeInput input = sheet.input(0.5f, 0.2f);  // a dab every 0.1 units, every 10 pixels
        double x = 100;
        input.begin({0, x, 400, 1});
        for (std::uint64_t i = 1; x < 600; ++i)
            input.move({i * 1000, x = std::min(600.0, x + step_px), 400, 1});
        input.end({1000000, 600, 400, 1});
        ASSERT_GE(sheet.dabs.size(), 50u) << step_px;
        ASSERT_LE(sheet.dabs.size(), 51u) << step_px;
        for (std::size_t i = 1; i < sheet.dabs.size(); ++i)
            EXPECT_NEAR(Sheet::place(sheet.dabs[i]).x - Sheet::place(sheet.dabs[i - 1]).x, 0.1, 1e-4)
                << step_px;
    }
}

TEST(StrokeInput, SlopesCountTheirLength) {
    Sheet sheet;
    sheet.height = [](float x, float, std::size_t) { return 3 * x; };
    StrokeInput input = sheet.input(0.5f, 0.2f);
    input.begin({0, 100, 400, 1});
    input.end({1000, 500, 400, 1});  // 4 units across, 12.65 along the slope
    EXPECT_NEAR(static_cast<double>(sheet.dabs.size()), 127, 1);
}

TEST(StrokeInput, AHoleIsNotBridged) {
    Sheet sheet;
    sheet.exists = [](float x, float) { return x < 2 || x > 3; };
    StrokeInput input = sheet.input(0.5f, 0.2f);
    input.begin({0, 100, 400, 1});
    input.end({1000, 400, 400, 1});
    ASSERT_FALSE(sheet.dabs.empty());
    for (const Dab& dab : sheet.dabs) {
        const double x = Sheet::place(dab).x;
        EXPECT_TRUE(x < 2 || x > 3) << x;
    }
    EXPECT_NEAR(static_cast<double>(sheet.dabs.size()), 20, 3);
}

TEST(StrokeInput, ACliffBehindASilhouetteIsJumpedNotFilled) {
    Sheet sheet;
    sheet.height = [](float x, float, std::size_t) { return x < 3 ? 0.0f : -1000.0f; };
    StrokeInput input = sheet.input(0.1f, 0.2f);
    input.begin({0, 250, 400, 1});
    input.end({1000, 350, 400, 1});
    EXPECT_LT(sheet.dabs.size(), 60u);
}

TEST(StrokeInput, ABrushFarBelowAPixelStaysBounded) {
    Sheet sheet;
    StrokeInput input = sheet.input(1e-6f, 0.02f);
    input.begin({0, 100, 400, 1});
    input.end({1000, 700, 400, 1});
    EXPECT_LT(sheet.dabs.size(), 3000u);
}

TEST(StrokeInput, AStrokeThatStartsBesideTheObjectBeginsWhereItMeetsIt) {
    Sheet sheet;
    StrokeInput input = sheet.input(0.5f, 0.2f);
    input.begin({0, -50, 400, 1});
    EXPECT_TRUE(sheet.dabs.empty());
    input.end({1000, 100, 400, 1});
    ASSERT_FALSE(sheet.dabs.empty());
    EXPECT_LT(Sheet::place(sheet.dabs[0]).x, 0.03);
}

TEST(StrokeInput, AClickIsOneDab) {
    Sheet sheet;
    StrokeInput input = sheet.input(0.5f, 0.2f);
    input.begin({5, 100, 400, 0.5});
    input.end({9, 100, 400, 0.5});
    ASSERT_EQ(sheet.dabs.size(), 1u);
    EXPECT_EQ(sheet.dabs[0].time_us, 0u);
    EXPECT_EQ(sheet.dabs[0].pressure, 32768u);
}

TEST(StrokeInput, OtherObjectsAreNotSculpted) {
    Sheet sheet;
    Brush brush;
    StrokeInput input(
        brush,
        [](std::span<const Ray> rays) {
            PickHit hit;
            hit.hit = true;
            hit.object = 1;
            return std::vector<PickHit>(rays.size(), hit);
        },
        [](double, double) {
            return Ray{{0, 0, 0}, {0, 0, 1}};
        },
        [&](const Dab& dab) { sheet.dabs.push_back(dab); });
    input.begin({0, 0, 0, 1});
    input.end({1, 50, 50, 1});
    EXPECT_TRUE(sheet.dabs.empty());
}

TEST(StrokeInput, AClockThatStepsBackKeepsItsTime) {
    Sheet sheet;
    StrokeInput input = sheet.input(0.5f, 0.2f);
    input.begin({5000, 100, 400, 1});
    input.move({9000, 200, 400, 1});
    input.end({1000, 300, 400, 1});
    for (std::size_t i = 1; i < sheet.dabs.size(); ++i)
        EXPECT_GE(sheet.dabs[i].time_us, sheet.dabs[i - 1].time_us);
    EXPECT_LE(sheet.dabs.back().time_us, 4000u);
}

TEST(StrokeInput, RoundedBarycentricsStayInTheTriangle) {
    PickHit hit;
    hit.hit = true;
    std::mt19937 random(3);
    for (int i = 0; i < 10000; ++i) {
        hit.b1 = static_cast<float>(random()) / 4294967296.0f * 1.0001f;
        hit.b2 = 1 - hit.b1 + 1e-7f;
        const Dab dab = quantised_dab(hit, 0, 1);
        ASSERT_LE(dab.b1 + dab.b2, Dab::kBarycentricOne);
    }
    hit.b1 = -1e-6f;
    hit.b2 = std::nanf("");
    const Dab dab = quantised_dab(hit, 0, 1);
    EXPECT_EQ(dab.b1, 0u);
    EXPECT_LE(dab.b2, Dab::kBarycentricOne);
}

}  // namespace
}  // namespace relievo::stroke_input_test
