// hand_overlay.cpp -- what the hand is about, drawn over the picture.
#include <string>
#include <utility>

#include "app/app.h"
#include "app/region_lines.h"
#include "core/text.h"

namespace pelage {
namespace {

ImVec2 at(vec2 place) { return {place.x, place.y}; }

// Lines on the picture, each with a dark edge so that it is seen on light fur.
class Ink {
public:
    explicit Ink(const App& app) : app_(app), draw_(*ImGui::GetBackgroundDrawList()) {
        const Viewport& viewport = app.viewport;
        draw_.PushClipRect(at(viewport.corner), at(viewport.corner + viewport.size));
    }
    ~Ink() { draw_.PopClipRect(); }
    Ink(const Ink&) = delete;
    Ink& operator=(const Ink&) = delete;

    void line(vec2 a, vec2 b) {
        draw_.AddLine(at(a), at(b), kEdge, app_.theme.px(3.5f));
        draw_.AddLine(at(a), at(b), color(), app_.theme.px(1.5f));
    }
    void dot(vec2 place) {
        draw_.AddCircleFilled(at(place), app_.theme.px(5), kEdge);
        draw_.AddCircleFilled(at(place), app_.theme.px(3.5f), color());
    }
    void outline(const std::vector<vec2>& path) {
        for (std::size_t i = 0; i < path.size(); ++i) line(path[i], path[(i + 1) % path.size()]);
    }
    // A label beside a place; `centered` on it.
    void label(vec2 place, const std::string& text, bool centered = false) {
        const ImVec2 size = ImGui::CalcTextSize(text.c_str());
        const float pad = app_.theme.px(7);
        const ImVec2 corner = centered ? ImVec2(place.x - 0.5f * size.x, place.y)
                                       : ImVec2(place.x + 2 * pad, place.y - 0.5f * size.y);
        draw_.AddRectFilled({corner.x - pad, corner.y - 0.6f * pad},
                            {corner.x + size.x + pad, corner.y + size.y + 0.6f * pad},
                            ImGui::GetColorU32(ImGuiCol_PopupBg), app_.theme.px(5));
        draw_.AddText(corner, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    }

private:
    static constexpr ImU32 kEdge = IM_COL32(0, 0, 0, 130);
    static ImU32 color() { return ImGui::GetColorU32(ImVec4(color::kAccent)); }
    const App& app_;
    ImDrawList& draw_;
};

std::string rampText(Tool tool, vec3 value) {
    if (toolInfo(tool).ofLength) return lengthText(value.x);
    return std::to_string(static_cast<int>(std::lround(100.0f * value.x))) + " %";
}

void drawGradient(const App& app, Ink& ink) {
    const auto tool = fieldOf(app.session.tool);
    const auto& path = app.viewport.path;
    if (!tool) return;
    const Ramp& ramp = app.session.hand.ramps[static_cast<std::size_t>(*tool)];
    ink.line(path.front(), path.back());
    ink.dot(path.front());
    ink.dot(path.back());
    if (*tool == Tool::tint) return;
    ink.label(path.front(), rampText(*tool, ramp.start));
    ink.label(path.back(), rampText(*tool, ramp.end));
}

// From the end of the last stroke to the pointer: what Shift+click would paint.
void drawNextLine(const App& app, Ink& ink) {
    const Viewport& viewport = app.viewport;
    const auto& end = app.session.hand.strokeEnd;
    const bool ready = viewport.drag == Drag::none || viewport.drag == Drag::click;
    if (!viewport.shift || !ready || !viewport.inside || !end) return;
    if (const auto start = placeOf(app, *end)) {
        ink.line(*start, viewport.pointer);
        ink.dot(*start);
    }
}

void drawLasso(const App& app, Ink& ink) {
    std::vector<vec2> path;
    for (const vec3 corner : lassoInWorld(app)) {
        const auto place = placeOf(app, corner);
        if (!place) return;
        path.push_back(*place);
    }
    ink.outline(path);
}

std::string hintOf(const App& app) {
    switch (app.session.hand.job) {
        case Job::gradient:
            if (const auto tool = fieldOf(app.session.tool))
                return std::string("Gradient of ") + toolInfo(*tool).name +
                       ": drag from one place to another. Esc: back to the brush";
            return "";
        case Job::lasso:
            return "Lasso: drag around the hair. Esc: give up";
        case Job::center:
            return "Click on the skin: the middle of the region. Esc: give up";
        case Job::paint:
            break;
    }
    return "";
}

}  // namespace

void drawHand(App& app) {
    Ink ink(app);
    const Viewport& viewport = app.viewport;
    const Hand& hand = app.session.hand;
    const bool region = std::exchange(app.session.regionShown, false);
    if (viewport.drag == Drag::stroke && hand.string > 0.0f) {
        ink.line(viewport.brushAt, viewport.pointer);
        ink.dot(viewport.pointer);
    }
    if (viewport.drag == Drag::gradient) drawGradient(app, ink);
    if (viewport.drag == Drag::lasso)
        ink.outline(viewport.path);
    else if (region)
        drawLasso(app, ink);
    if (hand.job == Job::paint) drawNextLine(app, ink);
    if (const std::string hint = hintOf(app); !hint.empty())
        ink.label(viewport.corner + vec2(0.5f * viewport.size.x, app.theme.px(12)), hint, true);
}

}  // namespace pelage
