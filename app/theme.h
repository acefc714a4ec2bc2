// theme.h -- how the editor looks: colors, spacing, fonts and icons, at any scale.
#pragma once

#include <imgui.h>

namespace pelage {

// A color that can be a constant; ImVec4 cannot.
struct Rgba {
    float x, y, z, w;
    operator ImVec4() const { return {x, y, z, w}; }
};

namespace color {
constexpr Rgba kBack{0.094f, 0.098f, 0.106f, 1.0f};  // behind everything
constexpr Rgba kPanel{0.125f, 0.129f, 0.141f, 1.0f};
constexpr Rgba kRaised{0.165f, 0.171f, 0.188f, 1.0f};  // groups, pop-ups
constexpr Rgba kFrame{0.208f, 0.216f, 0.237f, 1.0f};   // fields and buttons
constexpr Rgba kHover{0.263f, 0.273f, 0.300f, 1.0f};
constexpr Rgba kLine{0.236f, 0.246f, 0.272f, 1.0f};
constexpr Rgba kText{0.890f, 0.894f, 0.906f, 1.0f};
constexpr Rgba kDim{0.565f, 0.580f, 0.620f, 1.0f};
constexpr Rgba kAccent{0.878f, 0.565f, 0.290f, 1.0f};  // copper
constexpr Rgba kAccentDeep{0.463f, 0.306f, 0.176f, 1.0f};
constexpr Rgba kBad{0.910f, 0.408f, 0.365f, 1.0f};
}  // namespace color

// Fork Awesome code points, as UTF-8.
namespace icon {
constexpr const char* kOpen = "\xEF\x84\x95";
constexpr const char* kSave = "\xEF\x83\x87";
constexpr const char* kExport = "\xEF\x81\x85";
constexpr const char* kUndo = "\xEF\x83\xA2";
constexpr const char* kRedo = "\xEF\x80\x9E";
constexpr const char* kFrame = "\xEF\x81\xA5";
constexpr const char* kHelp = "\xEF\x81\x99";
constexpr const char* kMirror = "\xEF\x83\xAC";
constexpr const char* kFacing = "\xEF\x8A\xA8";
constexpr const char* kFolder = "\xEF\x81\xBB";
constexpr const char* kHome = "\xEF\x80\x95";
constexpr const char* kDisk = "\xEF\x82\xA0";
constexpr const char* kUp = "\xEF\x85\x88";
constexpr const char* kRecent = "\xEF\x80\x97";
constexpr const char* kPlay = "\xEF\x81\x8B";
constexpr const char* kPause = "\xEF\x81\x8C";
constexpr const char* kLoop = "\xEF\x80\x9E";
constexpr const char* kClose = "\xEF\x80\x8D";
constexpr const char* kBox = "\xEF\x86\xB2";
}  // namespace icon

struct Theme {
    float scale = 1.0f;  // window units per unit of the design
    ImFont* regular = nullptr;
    ImFont* strong = nullptr;
    ImFont* small = nullptr;
    ImFont* title = nullptr;
    bool icons = false;  // the icon font was found

    float px(float design) const { return design * scale; }
    // The icon, or "" without the icon font.
    const char* glyph(const char* which) const { return icons ? which : ""; }
};

// Fills the font atlas and the style. `scale` is as in Theme; `pixels` is how many pixels of the
// frame buffer one window unit has (2 on a dense display of macOS or Wayland, 1 on X11).
// The back end's font texture must be made anew afterwards.
Theme applyTheme(float scale, float pixels);

}  // namespace pelage
