// Colours, spacing and fonts of the interface.
#include "editor/gui/theme.h"

#include <array>
#include <filesystem>

namespace relievo::gui {
namespace {

constexpr float kFontPoints = 15;

struct Look {
    float scale = 1;
    ImFont* strong = nullptr;
};

Look& look() {
    static Look now;
    return now;
}

// Fonts of Debian's packages, best first. Dear ImGui's own bitmap font where there is none.
constexpr std::array kRegular{"/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
                              "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                              "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                              "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf"};
constexpr std::array kStrong{"/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Medium.ttf",
                             "/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf",
                             "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
                             "/usr/share/fonts/truetype/liberation/LiberationSans-Bold.ttf"};

template <typename Names>
ImFont* load_first(const Names& names, float size) {
    ImFontConfig config;
    config.OversampleH = 3;
    config.OversampleV = 2;
    std::error_code ignored;
    for (const char* name : names)
        if (std::filesystem::exists(name, ignored))
            if (ImFont* font = ImGui::GetIO().Fonts->AddFontFromFileTTF(name, size, &config)) return font;
    return nullptr;
}

void load_fonts(float size) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    if (!load_first(kRegular, size)) {
        ImFontConfig config;
        config.SizePixels = size;
        atlas.AddFontDefault(&config);
    }
    look().strong = load_first(kStrong, size);
    if (!look().strong) look().strong = atlas.Fonts[0];
}

ImVec4 grey(float value, float alpha = 1) {
    return {value, value * 1.02f, value * 1.07f, alpha};
}

void set_colours(ImVec4* c) {
    const ImVec4 accent = ImGui::ColorConvertU32ToFloat4(kAccent);
    const auto tint = [&](float alpha) { return ImVec4(accent.x, accent.y, accent.z, alpha); };
    c[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(kText);
    c[ImGuiCol_TextDisabled] = ImGui::ColorConvertU32ToFloat4(kTextDim);
    c[ImGuiCol_WindowBg] = ImGui::ColorConvertU32ToFloat4(kPanel);
    c[ImGuiCol_ChildBg] = grey(0, 0);
    c[ImGuiCol_PopupBg] = grey(0.135f, 0.99f);
    c[ImGuiCol_Border] = grey(0.27f);
    c[ImGuiCol_FrameBg] = grey(0.105f);
    c[ImGuiCol_FrameBgHovered] = grey(0.13f);
    c[ImGuiCol_FrameBgActive] = grey(0.15f);
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = grey(0.18f);
    c[ImGuiCol_ScrollbarBg] = grey(0, 0);
    c[ImGuiCol_ResizeGrip] = grey(0.26f);
    c[ImGuiCol_ResizeGripHovered] = tint(0.6f);
    c[ImGuiCol_ResizeGripActive] = accent;
    c[ImGuiCol_TableHeaderBg] = grey(0.17f);
    c[ImGuiCol_ScrollbarGrab] = grey(0.26f);
    c[ImGuiCol_ScrollbarGrabHovered] = grey(0.32f);
    c[ImGuiCol_ScrollbarGrabActive] = grey(0.38f);
    c[ImGuiCol_CheckMark] = accent;
    c[ImGuiCol_PlotHistogram] = accent;
    c[ImGuiCol_SliderGrab] = tint(0.85f);
    c[ImGuiCol_SliderGrabActive] = accent;
    c[ImGuiCol_Button] = grey(0.215f);
    c[ImGuiCol_ButtonHovered] = grey(0.27f);
    c[ImGuiCol_ButtonActive] = tint(0.75f);
    c[ImGuiCol_Header] = grey(0.19f);
    c[ImGuiCol_HeaderHovered] = grey(0.235f);
    c[ImGuiCol_HeaderActive] = grey(0.27f);
    c[ImGuiCol_Separator] = grey(0.10f);
    c[ImGuiCol_TextSelectedBg] = tint(0.35f);
    c[ImGuiCol_NavHighlight] = accent;
    c[ImGuiCol_ModalWindowDimBg] = ImVec4(0.02f, 0.02f, 0.03f, 0.55f);
}

}  // namespace

void apply_theme(double scale) {
    look().scale = static_cast<float>(scale);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // the layout is fixed
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    load_fonts(kFontPoints * look().scale);
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowPadding = {12, 10};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 7};
    style.ItemInnerSpacing = {6, 4};
    style.ScrollbarSize = 11;
    style.GrabMinSize = 9;
    style.WindowRounding = style.ChildRounding = 0;
    style.FrameRounding = style.GrabRounding = style.PopupRounding = 4;
    style.ScrollbarRounding = 6;
    style.WindowBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = 0;
    set_colours(style.Colors);
    style.ScaleAllSizes(look().scale);
}

float points(float value) {
    return value * look().scale;
}

ImFont* strong_font() {
    return look().strong;
}

}  // namespace relievo::gui
