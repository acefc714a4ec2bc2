// segment_panel.cpp -- the segments of the body, and combing along one or all of them.
#include <algorithm>
#include <string>

#include "app/panels/panels.h"
#include "core/segment_comb.h"

namespace pelage {
namespace {

void choose(SegmentChoice& choice, const Skin& skin, uint segment) {
    choice.chosen = segment;
    choice.axis = axisOf(skin.segments()[segment]);
}

void drawList(App& app, SegmentChoice& choice) {
    const Skin& skin = app.skin();
    ImGui::BeginChild("segments", {0, app.theme.px(210)});
    for (uint s = 0; s < skin.segments().size(); ++s) {
        ImGui::PushID(static_cast<int>(s));
        if (ImGui::Selectable("##segment", s == choice.chosen)) choose(choice, skin, s);
        ImGui::SameLine(app.theme.px(6));
        ImGui::TextUnformatted(skin.segments()[s].name.c_str());
        const std::string count = grouped(choice.vertices[s]);
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(count.c_str()).x -
                        app.theme.px(6));
        ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
        ImGui::TextUnformatted(count.c_str());
        ImGui::PopStyleColor();
        ImGui::PopID();
    }
    ImGui::EndChild();
}

void drawAxis(Ui ui, SegmentChoice& choice) {
    constexpr const char* kNames[] = {"Axis x", "Axis y", "Axis z"};
    for (int i = 0; i < 3; ++i)
        if (const auto value = numberRow(ui, kNames[i], choice.axis[i],
                                         {.least = -1.0f,
                                          .format = "%.2f",
                                          .help = "Where the hair of the segment lies, in the "
                                                  "world: the arrow in the view."}))
            choice.axis[i] = *value;
}

}  // namespace

void drawSegments(App& app) {
    const Ui ui = uiOf(app);
    const Skin& skin = app.skin();
    SegmentChoice& choice = app.session.segment;
    choice.shown = true;
    if (skin.segments().empty()) {
        ImGui::TextWrapped("This mesh has no body segments: they come from the joints of a skin.");
        return;
    }
    if (choice.axis == vec3(0.0f) && choice.chosen == 0) choose(choice, skin, 0);
    caption(ui, "SEGMENTS AND THEIR VERTICES");
    drawList(app, choice);
    drawAxis(ui, choice);
    if (const auto weight = numberRow(ui, "Weight", choice.weight,
                                      {.fallback = 1.0f,
                                       .format = "%.2f",
                                       .help = "0 leaves the direction as it is, 1 replaces it."}))
        choice.weight = *weight;
    const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    ImGui::BeginDisabled(choice.axis == vec3(0.0f));
    if (primaryButton(ui, "Apply", half)) combAlong(app, choice.chosen, choice.axis, choice.weight);
    tip(ui, "Combs the segment along the axis.");
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (plainButton(ui, "Reverse", half)) choice.axis = -choice.axis;
    tip(ui, "Turns the axis round.");
    caption(ui, "WHOLE BODY");
    if (plainButton(ui, "Comb from head to tail", ImGui::GetContentRegionAvail().x))
        combBody(app, choice.weight);
    tip(ui, "Follows all segments, without seams at their borders.");
}

}  // namespace pelage
