// Views: their round, the map's value, and the lines of the base mesh and its prisms.
#include "editor/gui/views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "editor/gui/map_value.h"
#include "editor/gui/prism_lines.h"
#include "tests/session/test_scene.h"

namespace relievo::gui::views_test {
namespace {

TEST(Views, TheRoundMeetsEveryViewOnceBothWays) {
    for (const int step : {1, -1}) {
        std::set<View> met;
        View view = View::beauty;
        for (std::size_t i = 0; i < views().size(); ++i) {
            met.insert(view);
            EXPECT_EQ(view_info(view).view, view);
            EXPECT_EQ(next_view(next_view(view, step), -step), view);
            view = next_view(view, step);
        }
        EXPECT_EQ(view, View::beauty);
        EXPECT_EQ(met.size(), views().size());
    }
}

TEST(MapValue, IsBilinearBetweenTexelCentresAndWrapsAsTheSceneSays) {
    HeightMap map(2, 1, 0);
    map.set(1, 0, 1000);
    EXPECT_DOUBLE_EQ(map_value(map, Wrap::repeat, {0.25, 0.5}), 0);
    EXPECT_DOUBLE_EQ(map_value(map, Wrap::repeat, {0.5, 0.5}), 500);
    EXPECT_DOUBLE_EQ(map_value(map, Wrap::repeat, {0, 0.5}), 500) << "half of the texel beyond the border";
    EXPECT_DOUBLE_EQ(map_value(map, Wrap::clamp, {0, 0.5}), 0);
    EXPECT_DOUBLE_EQ(map_value(map, Wrap::clamp, {7, -3}), 1000);
}

class Prisms : public testing::Test {
  protected:
    Prisms() : session_(test::write_scene(folder_.path()), test::headless()) { lines_.follow(session_); }

    std::size_t count(const PrismView& view, OverlayLine::Kind kind) const {
        return static_cast<std::size_t>(
            std::count_if(view.lines.begin(), view.lines.end(),
                          [&](const OverlayLine& line) { return line.kind == kind; }));
    }
    PrismView view(const std::optional<glm::dvec2>& pointer, const PrismLimits& limits) const {
        return lines_.view(session_.scene(), {640, 480}, pointer, limits);
    }

    test::TemporaryFolder folder_;
    Session session_;
    PrismLines lines_;
};

constexpr std::size_t kTriangles = 2 * 8 * 8, kEdges = 2 * 8 * 9 + 8 * 8;  // of the sheet

TEST_F(Prisms, AnOpenMeshShowsEveryEdgeOnceAndEveryPrism) {
    const PrismView all = view(std::nullopt, {});
    EXPECT_EQ(count(all, OverlayLine::Kind::base), kEdges);
    EXPECT_EQ(count(all, OverlayLine::Kind::cap), 6 * kTriangles);
    EXPECT_EQ(count(all, OverlayLine::Kind::side), 3 * kTriangles);
    EXPECT_TRUE(all.note.empty());
}

TEST_F(Prisms, OfALargeMeshOnlyThoseNearThePointerAreShownAndANoteSaysSo) {
    const PrismLimits few{24000, 20, 40};
    const PrismView none = view(std::nullopt, few);
    EXPECT_EQ(count(none, OverlayLine::Kind::base), kEdges);
    EXPECT_EQ(count(none, OverlayLine::Kind::cap), 0u);
    EXPECT_NE(none.note.find("128 triangles"), std::string::npos) << none.note;
    const PrismView some = view(glm::dvec2(320, 240), few);
    const std::size_t caps = count(some, OverlayLine::Kind::cap);
    EXPECT_GT(caps, 0u);
    EXPECT_LE(caps, 6 * few.prisms);
}

TEST_F(Prisms, SidesGrowWithWhatIsSculpted) {
    const auto longest = [&] {
        double most = 0;
        for (const OverlayLine& line : view(std::nullopt, {}).lines)
            if (line.kind == OverlayLine::Kind::side)
                most = std::max(most, std::hypot(line.a.x - line.b.x, line.a.y - line.b.y));
        return most;
    };
    const double before = longest();
    session_.brush().strength = 1;
    test::sculpt(session_, 4, 30);
    lines_.follow(session_);
    EXPECT_GT(longest(), before * 1.2);
}

}  // namespace
}  // namespace relievo::gui::views_test
