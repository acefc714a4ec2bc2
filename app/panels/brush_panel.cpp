// brush_panel.cpp -- the left column: the tools and the brush.
#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "app/actions.h"
#include "app/panels/panels.h"
#include "app/tool_icons.h"
#include "core/spacing.h"

namespace pelage {
namespace {

void toolButton(App& app, const ToolInfo& info, float width) {
    const Action& action = actionNamed("brush." + std::string(info.name));
    const bool on = app.session.tool == info.tool;
    const float height = app.theme.px(30), side = app.theme.px(16);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushID(info.name);
    ImGui::PushStyleColor(ImGuiCol_Button, on ? color::kAccentDeep : color::kRaised);
    if (on) ImGui::PushStyleColor(ImGuiCol_ButtonHovered, color::kAccentDeep);
    if (ImGui::Button("##tool", {width, height})) perform(app, action);
    ImGui::PopStyleColor(on ? 2 : 1);
    tip(uiOf(app), action.help);
    ImGui::PopID();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImU32 ink = ImGui::GetColorU32(on ? color::kAccent : color::kText);
    const float inset = 0.5f * (height - side);
    drawToolIcon(draw, info.tool, {corner.x + app.theme.px(7), corner.y + inset}, side, ink);
    const float text = corner.y + 0.5f * (height - ImGui::GetTextLineHeight());
    draw.AddText({corner.x + app.theme.px(29), text}, ImGui::GetColorU32(ImGuiCol_Text),
                 info.label);
    const std::string key = shortcutText(action.keys[action.keys[1].key != 0 ? 1 : 0]);
    draw.AddText({corner.x + width - app.theme.px(15), text},
                 ImGui::GetColorU32(ImGuiCol_TextDisabled), key.c_str());
}

void drawModes(App& app, Brush& brush) {
    const ToolInfo& info = toolInfo(brush.tool);
    if (!info.add) return;
    const char* labels[] = {info.add, info.subtract, "Set", "Scale"};  // in the order of Mode
    const std::span shown(labels, info.hasScale ? 4u : info.hasSet ? 3u : 2u);
    if (const auto mode = choiceRow(uiOf(app), "mode", shown, static_cast<int>(brush.mode)))
        brush.mode = static_cast<Mode>(*mode);
}

// In the unit in which it is kept, on the skin or on the screen.
void drawRadius(App& app, LengthUnit unit, const char* format) {
    if (!app.isOpen()) return;
    const Ui ui = uiOf(app);
    const bool screen = app.session.hand.screenRadius;
    const float scale = screen ? 1.0f : app.skin().size() * unit.perMetre;
    Number number{.least = screen ? kLeastScreenRadius : kSmallestRadius * scale,
                  .greatest = screen ? kMostScreenRadius : kLargestRadius * scale,
                  .fallback = screen ? Hand().radius : kFirstRadius * scale,
                  .format = screen ? "%.0f px" : format,
                  .logarithmic = true,
                  .help = "Radius of the brush. [ and ] or F."};
    const float perUnit = screen ? 1.0f : unit.perMetre;
    rowLabel(ui, "Radius");
    const float button = app.theme.px(30), gap = app.theme.px(3);
    ImGui::SetNextItemWidth(ImGui::CalcItemWidth() - button - gap);
    if (const auto radius = numberBar(ui, "##radius", radiusInUnit(app) * perUnit, number))
        setRadiusInUnit(app, *radius / perUnit);
    ImGui::SameLine(0.0f, gap);
    ImGui::PushStyleColor(ImGuiCol_Button, screen ? color::kAccentDeep : color::kFrame);
    if (ImGui::Button("px", {button, 0.0f})) chooseScreenRadius(app, !screen);
    ImGui::PopStyleColor();
    tip(ui, "The radius stays the same on the screen, however near you are, and not on the skin.");
}

void drawNumbers(App& app, Brush& brush) {
    const Ui ui = uiOf(app);
    const float size = app.isOpen() ? app.skin().size() : 1.0f;
    const LengthUnit unit = unitFor(size);
    const std::string format = numberFormat(unit);
    drawRadius(app, unit, format.c_str());
    if (const auto strength = numberRow(ui, "Strength", brush.strength,
                                        {.least = 0.01f,
                                         .fallback = 0.5f,
                                         .format = "%.2f",
                                         .help = "Share of the full effect at the middle of the "
                                                 "brush. Shift+[ and Shift+] or Shift+F."}))
        brush.strength = *strength;
    const ToolInfo& info = toolInfo(brush.tool);
    if (brush.tool == Tool::tint) {
        static constexpr Parameter kColor{"tint",
                                          "Color",
                                          "",
                                          "What is painted; it multiplies the "
                                          "colors of the coat.",
                                          ParameterKind::color,
                                          0.0f,
                                          1.0f,
                                          0};
        if (const auto picked = parameterRow(ui, kColor, brush.color, vec3(1.0f), size))
            brush.color = glm::clamp(*picked, vec3(0.0f), vec3(1.0f));
    }
    if (brush.tool == Tool::segment && app.isOpen())
        app.session.segment.chosen = segmentRow(app, app.session.segment.chosen);
    if (brush.mode == Mode::scale && info.hasScale) {
        if (const auto factor = numberRow(ui, "Factor", brush.factor,
                                          {.least = 0.0f,
                                           .greatest = 2.0f,
                                           .fallback = 0.5f,
                                           .format = "x %.2f",
                                           .help = "What Scale multiplies by."}))
            brush.factor = std::clamp(*factor, 0.0f, kGreatestFactor);
        return;
    }
    if (!info.hasSet) return;
    const bool length = info.ofLength;
    const float scale = length ? unit.perMetre : 1.0f;
    const float first = !length ? 1.0f : app.isOpen() ? firstLength(app.skin()) : brush.value;
    const char* help = info.add ? "What Set paints." : "Longer hair is cut to this length.";
    ImGui::BeginDisabled(brush.mode != Mode::set);
    if (const auto value = numberRow(ui, info.add ? "Value" : "Length", brush.value * scale,
                                     {.least = info.least * (length ? size : 1.0f) * scale,
                                      .greatest = info.greatest * (length ? size : 1.0f) * scale,
                                      .fallback = first * scale,
                                      .format = length ? format.c_str() : "%.2f",
                                      .help = help}))
        brush.value = *value / scale;
    ImGui::EndDisabled();
}

void drawFlood(App& app, const Brush& brush) {
    const Ui ui = uiOf(app);
    if (brush.tool == Tool::comb) {
        constexpr const char* kNames[] = {"Backward", "Forward", "Down", "Up", "Left", "Right"};
        constexpr vec3 kDirections[] = {{0, 0, -1}, {0, 0, 1}, {0, -1, 0},
                                        {0, 1, 0},  {1, 0, 0}, {-1, 0, 0}};
        int chosen = 0;
        for (int i = 0; i < 6; ++i)
            if (kDirections[i] == app.session.floodDirection) chosen = i;
        rowLabel(ui, "Flood to");
        if (const auto other = choiceList(ui, "##direction", kNames, chosen))
            app.session.floodDirection = kDirections[*other];
    }
    constexpr const char* kButtons[] = {"brush.flood", "brush.reset"};
    actionButtons(app, kButtons, 2);
    drawGradient(app);
}

void drawMirror(App& app) {
    const Ui ui = uiOf(app);
    rowLabel(ui, "Mirror");
    constexpr const char* kNames[] = {"brush.mirror", "brush.mirrorY", "brush.mirrorZ"};
    constexpr const char* kAxes[] = {"X", "Y", "Z"};
    for (int axis = 0; axis < 3; ++axis) {
        const Action& action = actionNamed(kNames[axis]);
        if (axis > 0) ImGui::SameLine();
        if (iconButton(ui, "", kAxes[axis], action.checked(app), true)) perform(app, action);
        tip(ui, action.help);
    }
}

// Empty unless the brush is smaller than the mesh is fine, where the pointer is or at large.
std::string coarseNote(const App& app) {
    if (!app.isOpen()) return {};
    const Skin& skin = app.skin();
    const std::optional<SkinHit>& hit = app.viewport.hit;
    const vec3 place = hit ? hit->position : app.session.camera.target;
    const float radius = brushInHand(app, place, false, false).radius;
    if (!hit) {
        if (radius >= skin.spacing) return {};
        return "The vertices of the mesh are " + lengthText(skin.spacing) + " apart.";
    }
    const uvec3 corners = skin.triangles[hit->triangle];
    if (radius >= std::max({spacingAt(skin, corners.x), spacingAt(skin, corners.y),
                            spacingAt(skin, corners.z)}))
        return {};
    std::vector<uint> under;
    app.workspace.query->within(hit->position, radius, under);
    return "The mesh has " + (under.empty() ? "no" : std::to_string(under.size())) +
           (under.size() == 1 ? " vertex" : " vertices") + " under this brush.";
}

}  // namespace

void drawBrushPanel(App& app, const Layout& layout) {
    const float top = layout.menu + layout.toolbar;
    beginPanel("brush", {0, top}, {layout.left, layout.window.y - top - layout.bottom()});
    const Ui ui = uiOf(app);
    Brush& brush = app.session.brush();
    caption(ui, "BRUSHES");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, app.theme.px(3)});
    const float gap = app.theme.px(3), half = 0.5f * (ImGui::GetContentRegionAvail().x - gap);
    for (const ToolInfo& info : tools()) {  // in two columns
        const bool left = static_cast<int>(info.tool) % 2 == 0;
        const bool alone = left && &info == &tools().back();
        toolButton(app, info, alone ? 2.0f * half + gap : half);
        if (left && !alone) ImGui::SameLine(0.0f, gap);
    }
    ImGui::PopStyleVar();

    caption(ui, "EFFECT");
    drawModes(app, brush);
    drawNumbers(app, brush);
    constexpr const char* kFalloffs[] = {"Smooth", "Linear", "Sharp", "Constant"};
    rowLabel(ui, "Falloff");
    if (const auto other = choiceList(ui, "##falloff", kFalloffs, static_cast<int>(brush.falloff)))
        brush.falloff = static_cast<Falloff>(*other);
    tip(ui, "How the effect fades from the middle of the brush to its edge.");
    if (brush.tool == Tool::mask) drawMaskButtons(app);

    caption(ui, "WHERE");
    drawMirror(app);
    for (const char* name : {"brush.surface", "brush.facing"}) {
        const Action& action = actionNamed(name);
        bool on = action.checked(app);
        if (toggleRow(ui, action.label, &on, action.help)) perform(app, action);
        ImGui::SameLine();
        const std::string key = shortcutText(action.keys[0]);
        ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x -
                             ImGui::CalcTextSize(key.c_str()).x);
        ImGui::TextDisabled("%s", key.c_str());
    }
    caption(ui, "EVERYWHERE");
    drawFlood(app, brush);
    drawHandRows(app);

    ImGui::Dummy({0, app.theme.px(4)});
    ImGui::PushFont(app.theme.small);
    ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
    ImGui::TextWrapped(
        "Ctrl: the other way. Shift: smooth.\nShift+click: a line from the last stroke.");
    if (const std::string note = coarseNote(app); !note.empty())
        ImGui::TextWrapped("%s", note.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
    ImGui::End();
}

}  // namespace pelage
