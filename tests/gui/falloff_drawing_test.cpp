// The custom falloff drawn with a mouse in its preview, without a window.
#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>

#include "editor/gui/panels.h"
#include "editor/gui/theme.h"

namespace relievo::gui::falloff_drawing_test {
namespace {

class FalloffDrawing : public testing::Test {
  protected:
    FalloffDrawing() {
        ImGui::CreateContext();
        apply_theme(1);
        ImGui::GetIO().DisplaySize = {400, 300};
        ImGui::GetIO().Fonts->Build();
        brush_.falloff = Falloff::custom;
        frame({-1, -1}, -1);
    }
    ~FalloffDrawing() override { ImGui::DestroyContext(); }

    // `button` is down; -1: none.
    void frame(ImVec2 mouse, int button) {
        ImGuiIO& io = ImGui::GetIO();
        io.DeltaTime = 0.05f;
        io.MousePos = mouse;
        for (int i = 0; i < 2; ++i) io.MouseDown[i] = i == button;
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({300, 300});
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar);
        draw_falloff_preview(brush_);
        low_ = ImGui::GetItemRectMin(), high_ = ImGui::GetItemRectMax();
        ImGui::End();
        ImGui::Render();
    }
    void click(ImVec2 at, int button = 0) {
        frame(at, -1);
        frame(at, button);
        frame(at, -1);
    }
    void drag(ImVec2 from, ImVec2 to) {
        frame(from, -1);
        frame(from, 0);
        for (int i = 1; i <= 4; ++i) {
            const float part = static_cast<float>(i) / 4;
            frame({from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)}, 0);
        }
        frame(to, -1);
        for (int i = 0; i < 20; ++i) frame(to, -1);  // the next press is no double click
    }
    // Where the profile shows a weight at a part of the radius right of the middle.
    ImVec2 place(float part, float weight) const {
        const float margin = 6;
        return {low_.x + margin + (0.5f + 0.5f * part) * (high_.x - low_.x - 2 * margin),
                high_.y - margin - weight * (high_.y - low_.y - 2 * margin)};
    }

    Brush brush_;
    ImVec2 low_, high_;
};

TEST_F(FalloffDrawing, aPointFollowsThePointerOnEitherSide) {
    drag(place(0.5f, 0.5f), place(0.6f, 0.9f));
    ASSERT_EQ(brush_.falloff_curve.points().size(), 5u);
    EXPECT_NEAR(brush_.falloff_curve.points()[2].part, 0.6f, 0.02f);
    EXPECT_NEAR(brush_.falloff_curve.points()[2].weight, 0.9f, 0.02f);
    drag(place(-0.6f, 0.9f), place(-0.4f, 0.3f));
    EXPECT_NEAR(brush_.falloff_curve.points()[2].part, 0.4f, 0.02f);
    EXPECT_NEAR(brush_.falloff_curve.points()[2].weight, 0.3f, 0.02f);
}

TEST_F(FalloffDrawing, itGoesNoFurtherThanItsNeighboursAndTheFrame) {
    drag(place(0.5f, 0.5f), place(3, -2));
    const auto points = brush_.falloff_curve.points();
    EXPECT_EQ(points[2].part, points[3].part - FalloffCurve::kLeastStep);
    EXPECT_EQ(points[2].weight, 0);
    drag(place(1, 0), place(0.7f, 1));
    EXPECT_EQ(brush_.falloff_curve.points().back(), (CurvePoint{1, 1}));
}

TEST_F(FalloffDrawing, hardnessMovesThePointsOutwards) {
    brush_.hardness = 0.5f;
    drag(place(0.75f, 0.5f), place(0.75f, 0.7f));
    EXPECT_NEAR(brush_.falloff_curve.points()[2].part, 0.5f, 0.02f);
    EXPECT_NEAR(brush_.falloff_curve.points()[2].weight, 0.7f, 0.02f);
}

TEST_F(FalloffDrawing, clicksAddAndTakeAwayAndADoubleClickStartsAnew) {
    click(place(0.12f, 0.4f));
    ASSERT_EQ(brush_.falloff_curve.points().size(), 6u);
    EXPECT_NEAR(brush_.falloff_curve.points()[1].weight, 0.4f, 0.02f);
    click(place(0.5f, 0.5f), 1);
    EXPECT_EQ(brush_.falloff_curve.points().size(), 5u);
    click(place(0, 1), 1);
    EXPECT_EQ(brush_.falloff_curve.points().size(), 5u) << "the middle stays";
    for (int i = 0; i < 20; ++i) frame(place(0, 1), -1);
    click(place(0.9f, 0.9f));
    click(place(0.9f, 0.9f));
    EXPECT_EQ(brush_.falloff_curve, FalloffCurve());
}

TEST_F(FalloffDrawing, otherFalloffsAreOnlyShown) {
    brush_.falloff = Falloff::sharp;
    drag(place(0.5f, 0.5f), place(0.5f, 0.9f));
    EXPECT_EQ(brush_.falloff_curve, FalloffCurve());
}

}  // namespace
}  // namespace relievo::gui::falloff_drawing_test
