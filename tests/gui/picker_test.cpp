// A colour's picker stays within a window that shrinks while it is open, without a window.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "editor/gui/theme.h"
#include "editor/gui/widgets.h"

namespace relievo::gui::picker_test {
namespace {

class Picker : public testing::Test {
  protected:
    Picker() {
        ImGui::CreateContext();
        apply_theme(1);
        ImGui::GetIO().Fonts->Build();
    }
    ~Picker() override { ImGui::DestroyContext(); }

    // A panel at the right edge with the colour near its lower end.
    void frame(ImVec2 window, bool button = false) {
        constexpr float kWidth = 300;
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = window;
        io.DeltaTime = 0.05f;
        io.MouseDown[0] = button;
        ImGui::NewFrame();
        keep_lists_in_window();
        ImGui::SetNextWindowPos({window.x - kWidth, 0});
        ImGui::SetNextWindowSize({kWidth, window.y});
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration);
        ImGui::SetCursorPosY(window.y - 60);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::SetNextItemWidth(200);
        color_edit("##colour", rgb_, ImGuiColorEditFlags_PickerHueBar);
        io.MousePos = {at.x + 200 - ImGui::GetFrameHeight() / 2, at.y + ImGui::GetFrameHeight() / 2};  // the patch
        ImGui::End();
        ImGui::Render();
    }

    static const ImGuiWindow* open() {
        const auto& stack = ImGui::GetCurrentContext()->OpenPopupStack;
        return stack.empty() ? nullptr : stack.back().Window;
    }
    static void expect_within(ImVec2 window) {
        ASSERT_NE(open(), nullptr);
        const ImRect rect = open()->Rect();
        EXPECT_GE(rect.Min.x, 0);
        EXPECT_GE(rect.Min.y, 0);
        EXPECT_LE(rect.Max.x, window.x);
        EXPECT_LE(rect.Max.y, window.y);
    }

    float rgb_[3] = {0.8f, 0.3f, 0.2f};
};

TEST_F(Picker, StaysWithinAWindowThatShrinks) {
    const ImVec2 large(1200, 800), small(640, 400), tiny(320, 120);
    for (const bool button : {false, false, true, false, false, false}) frame(large, button);
    ASSERT_NE(open(), nullptr) << "a click on the patch opens it";
    expect_within(large);
    EXPECT_GT(open()->Rect().Max.x, small.x);
    for (int i = 0; i < 3; ++i) frame(small);
    expect_within(small);
    const ImVec2 whole = open()->Size;
    EXPECT_EQ(open()->ScrollMax.y, 0) << "there is room for all of it";
    for (int i = 0; i < 3; ++i) frame(tiny);
    expect_within(tiny);
    EXPECT_GT(open()->ScrollMax.y, 0) << "what there is no room for can be scrolled to";
    for (int i = 0; i < 3; ++i) frame(large);
    expect_within(large);
    EXPECT_EQ(open()->Size.y, whole.y);
}

}  // namespace
}  // namespace relievo::gui::picker_test
