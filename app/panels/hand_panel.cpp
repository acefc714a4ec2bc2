// hand_panel.cpp -- in the brush panel: the steadied hand, gradients, operations on the mask.
#include <span>

#include "app/actions.h"
#include "app/panels/panels.h"

namespace pelage {
namespace {

void rampRow(App& app, Tool tool, const char* label, vec3& value, vec3 fallback) {
    const Ui ui = uiOf(app);
    const float size = app.skin().size();
    if (tool == Tool::tint) {
        const Parameter row{label, label, "", "The color at this end.", ParameterKind::color,
                            0.0f,  1.0f,  0};
        if (const auto picked = parameterRow(ui, row, value, fallback, size))
            value = glm::clamp(*picked, vec3(0.0f), vec3(1.0f));
        return;
    }
    const ToolInfo& info = toolInfo(tool);
    const LengthUnit unit = unitFor(size);
    const float scale = info.ofLength ? unit.perMetre : 1.0f;
    const std::string format = info.ofLength ? numberFormat(unit) : "%.2f";
    if (const auto number =
            numberRow(ui, label, value.x * scale,
                      {.greatest = info.greatest * (info.ofLength ? size : 1.0f) * scale,
                       .fallback = fallback.x * scale,
                       .format = format.c_str(),
                       .help = "The value at this end of the drag."}))
        value = vec3(*number / scale);
}

}  // namespace

void actionButtons(App& app, std::span<const char* const> names, int columns) {
    const Ui ui = uiOf(app);
    const float gap = app.theme.px(3);
    const float width = (ImGui::GetContentRegionAvail().x - gap * static_cast<float>(columns - 1)) /
                        static_cast<float>(columns);
    int column = 0;
    for (const char* name : names) {
        const Action& action = actionNamed(name);
        if (column > 0) ImGui::SameLine(0.0f, gap);
        column = (column + 1) % columns;
        ImGui::BeginDisabled(!isEnabled(app, action));
        if (plainButton(ui, action.label, width)) perform(app, action);
        ImGui::EndDisabled();
        tip(ui, action.help);
    }
}

void drawMaskButtons(App& app) {
    caption(uiOf(app), "MASK");
    constexpr const char* kThree[] = {"mask.invert", "mask.clear",  "mask.fill",
                                      "mask.grow",   "mask.shrink", "mask.smooth"};
    constexpr const char* kTwo[] = {"mask.length", "mask.density"};
    constexpr const char* kOne[] = {"mask.region"};
    actionButtons(app, kThree, 3);
    actionButtons(app, kTwo, 2);
    actionButtons(app, kOne, 1);
}

void drawGradient(App& app) {
    const Action& action = actionNamed("brush.gradient");
    const bool on = action.checked(app);
    ImGui::PushStyleColor(ImGuiCol_Button, on ? color::kAccentDeep : color::kFrame);
    constexpr const char* kGradient[] = {"brush.gradient"};
    actionButtons(app, kGradient, 1);
    ImGui::PopStyleColor();
    const auto tool = fieldOf(app.session.tool);
    if (!on || !tool || !app.isOpen()) return;
    Hand& hand = app.session.hand;
    Ramp& ramp = hand.ramps[static_cast<std::size_t>(*tool)];
    const float most = toolInfo(*tool).ofLength ? firstLength(app.skin()) : 1.0f;
    rampRow(app, *tool, "From", ramp.start, vec3(most));
    rampRow(app, *tool, "To", ramp.end, vec3(0.0f));
    toggleRow(uiOf(app), "Only between", &hand.between,
              "Leaves hair alone that lies beyond the ends; otherwise it takes the value of the "
              "nearer end.");
}

void drawHandRows(App& app) {
    const Ui ui = uiOf(app);
    Hand& hand = app.session.hand;
    caption(ui, "HAND");
    if (const auto string = numberRow(ui, "Stabiliser", hand.string,
                                      {.greatest = kLongestString,
                                       .format = hand.string > 0.0f ? "%.0f px" : "off",
                                       .help = "Length of the string by which the brush hangs "
                                               "behind the pointer: the longer, the steadier."}))
        hand.string = *string;
    toggleRow(ui, "Pen pressure", &hand.pen,
              "The pressure of a pen scales the strength (X11). Without a pen hold Z while "
              "painting for a light touch.");
}

}  // namespace pelage
