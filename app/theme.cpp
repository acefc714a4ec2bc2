// theme.cpp -- style and fonts.
#include "app/theme.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <span>
#include <string>

namespace pelage {
namespace {

// Where distributions keep the fonts; the first that is there is taken.
constexpr std::array kRegularFonts = {
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
    "/usr/share/fonts/truetype/roboto/Roboto-Regular.ttf",
    "/usr/share/fonts/google-roboto/Roboto-Regular.ttf",
    "/usr/share/fonts/TTF/Roboto-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
};
constexpr std::array kStrongFonts = {
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Medium.ttf",
    "/usr/share/fonts/truetype/roboto/Roboto-Medium.ttf",
    "/usr/share/fonts/google-roboto/Roboto-Medium.ttf",
    "/usr/share/fonts/TTF/Roboto-Medium.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
};
constexpr std::array kIconFonts = {
    "/usr/share/fonts-fork-awesome/fonts/forkawesome-webfont.ttf",
    "/usr/share/fonts/fork-awesome/forkawesome-webfont.ttf",
};

// Latin, Greek, Cyrillic and the punctuation of file names and help texts.
constexpr ImWchar kTextRange[] = {0x20,   0x24F,  0x370,  0x52F,  0x2010, 0x2044, 0x2190,
                                  0x2193, 0x2206, 0x2206, 0x2264, 0x2265, 0};
constexpr ImWchar kIconRange[] = {0xF000, 0xF2E0, 0};

const char* firstThatExists(std::span<const char* const> paths) {
    for (const char* path : paths) {
        std::error_code failed;
        if (std::filesystem::is_regular_file(path, failed)) return path;
    }
    return nullptr;
}

ImFont* addFont(std::span<const char* const> paths, float size, bool icons) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    ImFont* font = nullptr;
    if (const char* path = firstThatExists(paths)) {
        font = atlas.AddFontFromFileTTF(path, size, nullptr, kTextRange);
    } else {
        ImFontConfig plain;
        plain.SizePixels = std::floor(size);
        font = atlas.AddFontDefault(&plain);
    }
    const char* iconFile = icons ? firstThatExists(kIconFonts) : nullptr;
    if (iconFile) {
        ImFontConfig merged;
        merged.MergeMode = true;
        merged.GlyphMinAdvanceX = std::floor(size * 1.15f);
        merged.GlyphOffset.y = std::floor(size * 0.06f);
        atlas.AddFontFromFileTTF(iconFile, std::floor(size * 0.95f), &merged, kIconRange);
    }
    return font;
}

ImVec4 faded(ImVec4 c, float alpha) { return {c.x, c.y, c.z, alpha}; }

void setColors(ImGuiStyle& style) {
    using namespace color;
    ImVec4* c = style.Colors;
    c[ImGuiCol_Text] = kText;
    c[ImGuiCol_TextDisabled] = kDim;
    c[ImGuiCol_WindowBg] = kPanel;
    c[ImGuiCol_ChildBg] = faded(kPanel, 0.0f);
    c[ImGuiCol_PopupBg] = kRaised;
    c[ImGuiCol_Border] = kLine;
    c[ImGuiCol_BorderShadow] = {0, 0, 0, 0};
    c[ImGuiCol_FrameBg] = kFrame;
    c[ImGuiCol_FrameBgHovered] = kHover;
    c[ImGuiCol_FrameBgActive] = kHover;
    c[ImGuiCol_TitleBg] = kRaised;
    c[ImGuiCol_TitleBgActive] = kRaised;
    c[ImGuiCol_TitleBgCollapsed] = kRaised;
    c[ImGuiCol_MenuBarBg] = kPanel;
    c[ImGuiCol_ScrollbarBg] = faded(kPanel, 0.0f);
    c[ImGuiCol_ScrollbarGrab] = kFrame;
    c[ImGuiCol_ScrollbarGrabHovered] = kHover;
    c[ImGuiCol_ScrollbarGrabActive] = kHover;
    c[ImGuiCol_CheckMark] = kAccent;
    c[ImGuiCol_SliderGrab] = kAccent;
    c[ImGuiCol_SliderGrabActive] = kAccent;
    c[ImGuiCol_Button] = kFrame;
    c[ImGuiCol_ButtonHovered] = kHover;
    c[ImGuiCol_ButtonActive] = kAccentDeep;
    c[ImGuiCol_Header] = faded(kAccentDeep, 0.65f);
    c[ImGuiCol_HeaderHovered] = kHover;
    c[ImGuiCol_HeaderActive] = kAccentDeep;
    c[ImGuiCol_Separator] = kLine;
    c[ImGuiCol_SeparatorHovered] = kLine;
    c[ImGuiCol_SeparatorActive] = kLine;
    c[ImGuiCol_ResizeGrip] = {0, 0, 0, 0};
    c[ImGuiCol_Tab] = kPanel;
    c[ImGuiCol_TabHovered] = kHover;
    c[ImGuiCol_TabActive] = kFrame;
    c[ImGuiCol_TabUnfocused] = kPanel;
    c[ImGuiCol_TabUnfocusedActive] = kFrame;
    c[ImGuiCol_TableHeaderBg] = kRaised;
    c[ImGuiCol_TableRowBgAlt] = faded(kText, 0.025f);
    c[ImGuiCol_TextSelectedBg] = faded(kAccent, 0.35f);
    c[ImGuiCol_DragDropTarget] = kAccent;
    c[ImGuiCol_NavHighlight] = kAccent;
    c[ImGuiCol_ModalWindowDimBg] = {0.0f, 0.0f, 0.0f, 0.55f};
    c[ImGuiCol_PlotHistogram] = kAccent;
}

}  // namespace

Theme applyTheme(float scale, float pixels) {
    Theme theme;
    theme.scale = scale;
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    const float dots = scale * pixels;
    theme.regular = addFont(kRegularFonts, std::round(14.5f * dots), true);
    theme.strong = addFont(kStrongFonts, std::round(14.5f * dots), true);
    theme.small = addFont(kRegularFonts, std::round(12.5f * dots), true);
    theme.title = addFont(kStrongFonts, std::round(19.0f * dots), true);
    theme.icons = firstThatExists(kIconFonts) != nullptr;
    io.FontDefault = theme.regular;
    io.FontGlobalScale = 1.0f / pixels;

    ImGuiStyle style;
    style.WindowPadding = {12, 10};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 5};
    style.ItemInnerSpacing = {6, 4};
    style.CellPadding = {6, 3};
    style.IndentSpacing = 14;
    style.ScrollbarSize = 11;
    style.GrabMinSize = 9;
    style.WindowRounding = 7;
    style.ChildRounding = 5;
    style.FrameRounding = 4;
    style.PopupRounding = 6;
    style.ScrollbarRounding = 6;
    style.GrabRounding = 4;
    style.TabRounding = 4;
    style.WindowBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = 0;
    style.ChildBorderSize = 1;
    style.WindowTitleAlign = {0.5f, 0.5f};
    style.ScaleAllSizes(scale);
    style.PopupBorderSize = 1;
    style.ChildBorderSize = 1;
    style.AntiAliasedLinesUseTex = false;
    setColors(style);
    ImGui::GetStyle() = style;
    return theme;
}

}  // namespace pelage
