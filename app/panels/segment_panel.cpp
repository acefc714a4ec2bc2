// segment_panel.cpp -- the segments of the body: their list, their axes, and combing along them.
#include "app/panels/panels.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "app/segment_arrow.h"
#include "app/view_actions.h"
#include "core/body.h"
#include "core/segment_comb.h"
#include "core/segment_parts.h"
#include "core/segment_text.h"

namespace pelage {
namespace {

const Groom& groomOf(const App& app) { return app.document().groom; }

const Segment& chosenOf(const App& app) { return groomOf(app).body()[app.session.segment.chosen]; }

void choose(App& app, uint segment) {
    app.session.segment.chosen = segment;
    app.session.segment.name = chosenOf(app).name;
}

// How many vertices each segment has; counted anew when some are another's.
void count(SegmentChoice& choice, const Groom& groom) {
    if (choice.counted == groom.segmentOf && choice.vertices.size() == groom.body().size()) return;
    choice.counted = groom.segmentOf;
    choice.vertices.assign(groom.body().size(), 0);
    for (std::size_t v = 0; v < groom.segmentOf.size(); ++v)
        if (groom.segmentOf[v] != kNoSegment) ++choice.vertices[groom.segmentOf[v]];
}

ImU32 inkOf(uint segment) {
    const vec3 shown = glm::pow(segmentColor(segment), vec3(1.0f / 2.2f));
    return ImGui::GetColorU32(ImVec4(shown.x, shown.y, shown.z, 1.0f));
}

void drawList(App& app) {
    const SegmentChoice& choice = app.session.segment;
    const std::span<const Segment> body = groomOf(app).body();
    ImGui::BeginChild("segments", {0, app.theme.px(210)});
    for (uint s = 0; s < body.size(); ++s) {
        ImGui::PushID(static_cast<int>(s));
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        if (ImGui::Selectable("##segment", s == choice.chosen)) choose(app, s);
        const float side = app.theme.px(9);
        const ImVec2 mark{corner.x + app.theme.px(4),
                          corner.y + 0.5f * (ImGui::GetTextLineHeight() - side)};
        ImGui::GetWindowDrawList()->AddRectFilled(mark, {mark.x + side, mark.y + side}, inkOf(s),
                                                  app.theme.px(2));
        ImGui::SameLine(app.theme.px(20));
        ImGui::TextUnformatted(body[s].name.c_str());
        const std::string vertices = grouped(choice.vertices[s]);
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(vertices.c_str()).x -
                        app.theme.px(6));
        ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
        ImGui::TextUnformatted(vertices.c_str());
        ImGui::PopStyleColor();
        ImGui::PopID();
    }
    ImGui::EndChild();
}

std::string freeName(std::span<const Segment> body) {
    for (std::size_t number = 1;; ++number) {
        const std::string name = "segment " + std::to_string(number);
        if (std::ranges::find(body, name, &Segment::name) == body.end()) return name;
    }
}

// Along the middle of the skin, for the hand to put it right.
void add(App& app) {
    const Skin& skin = *app.document().skin;  // axes are those of the rest pose
    const vec3 half(0.0f, 0.0f, 0.15f * skin.size());
    changeBody(app, addSegmentLine({freeName(groomOf(app).body()), skin.center() + half,
                                    skin.center() - half}));
    choose(app, static_cast<uint>(groomOf(app).body().size()) - 1);
}

// The axis along the vertices of the segment, as it is turned now.
void fit(App& app) {
    const Groom& groom = groomOf(app);
    const uint chosen = app.session.segment.chosen;
    const Skin& skin = *app.document().skin;
    std::vector<vec3> places;
    for (std::size_t v = 0; v < groom.segmentOf.size(); ++v)
        if (groom.segmentOf[v] == chosen) places.push_back(skin.vertices[v].position);
    const Segment& old = chosenOf(app);
    Segment fitted = segmentAlong(old.name, places, old.root);
    if (glm::dot(axisOf(fitted), axisOf(old)) < 0.0f) std::swap(fitted.root, fitted.tip);
    changeBody(app, moveSegmentLine(groom, chosen, fitted.root, fitted.tip));
}

void drawName(App& app) {
    SegmentChoice& choice = app.session.segment;
    rowLabel(uiOf(app), "Name");
    ImGui::SetNextItemWidth(-1);
    ImGui::InputText("##name", &choice.name);
    if (ImGui::IsItemDeactivatedAfterEdit() && choice.name != chosenOf(app).name)
        changeBody(app, renameSegmentLine(groomOf(app), choice.chosen, choice.name));
    if (!ImGui::IsItemActive()) choice.name = chosenOf(app).name;
}

void drawAxis(App& app) {
    constexpr const char* kNames[] = {"Axis x", "Axis y", "Axis z"};
    const Segment& segment = chosenOf(app);
    vec3 axis = axisOf(segment);
    bool changed = false;
    for (int i = 0; i < 3; ++i)
        if (const auto value = numberRow(uiOf(app), kNames[i], axis[i],
                                         {.least = -1.0f,
                                          .format = "%.2f",
                                          .help = "Where the hair of the segment lies, in the "
                                                  "world: the arrow in the view, whose ends can be "
                                                  "dragged (Ctrl keeps its direction)."})) {
            axis[i] = *value;
            changed = true;
        }
    const float length = glm::distance(segment.root, segment.tip);
    if (changed && glm::length(axis) > 0.0f && length > 0.0f)
        editAxis(app, app.session.segment.chosen, segment.root,
                 segment.root + length * glm::normalize(axis));
}

// Two buttons in a row; which of them was pressed.
struct Pressed {
    bool first = false, second = false;
};

struct Offer {
    const char *label, *help;
    bool enabled = true;
};

Pressed buttons(Ui ui, const Offer& first, const Offer& second) {
    const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    const auto button = [&](const Offer& offer) {
        ImGui::BeginDisabled(!offer.enabled);
        const bool on = plainButton(ui, offer.label, half);
        tip(ui, offer.help);
        ImGui::EndDisabled();
        return on;
    };
    Pressed pressed;
    pressed.first = button(first);
    ImGui::SameLine();
    pressed.second = button(second);
    return pressed;
}

// Which segments there are.
void drawBody(App& app) {
    const Ui ui = uiOf(app);
    const bool any = !groomOf(app).body().empty();
    const Pressed list = buttons(ui, {"Add", "One more segment, to which no skin belongs yet."},
                                 {"Remove", "Its skin belongs to no segment afterwards.", any});
    if (list.first) add(app);
    if (list.second) changeBody(app, removeSegmentLine(groomOf(app), app.session.segment.chosen));
}

void drawChosen(App& app) {
    const Ui ui = uiOf(app);
    SegmentChoice& choice = app.session.segment;
    drawName(app);
    drawAxis(app);
    const bool hasAxis = axisOf(chosenOf(app)) != vec3(0.0f);
    const Pressed axis = buttons(
        ui, {"Fit", "Lays the axis along the vertices.", choice.vertices[choice.chosen] > 1},
        {"Reverse", "Turns the axis round.", hasAxis});
    if (axis.first) fit(app);
    if (axis.second)
        changeBody(app, moveSegmentLine(groomOf(app), choice.chosen, chosenOf(app).tip,
                                        chosenOf(app).root));
    const float width = ImGui::GetContentRegionAvail().x;
    if (plainButton(ui, "Paint its skin", width)) paintSegments(app);
    tip(ui, "The Segment brush: says which skin belongs to the segment.");
    caption(ui, "COMB");
    if (const auto weight = numberRow(ui, "Weight", choice.weight,
                                      {.fallback = 1.0f,
                                       .format = "%.2f",
                                       .help = "0 leaves the direction as it is, 1 replaces it."}))
        choice.weight = *weight;
    ImGui::BeginDisabled(!hasAxis);
    if (primaryButton(ui, "Apply", width))
        combAlong(app, choice.chosen, axisOf(chosenOf(app)), choice.weight);
    tip(ui, "Combs the segment along its axis.");
    ImGui::EndDisabled();
    if (plainButton(ui, "Comb from head to tail", width)) combBody(app, choice.weight);
    tip(ui, "Follows all segments, without seams at their borders.");
}

}  // namespace

uint segmentRow(App& app, uint chosen) {
    std::vector<const char*> names;
    for (const Segment& segment : groomOf(app).body()) names.push_back(segment.name.c_str());
    if (names.empty()) return 0;
    rowLabel(uiOf(app), "Segment");
    chosen = std::min(chosen, static_cast<uint>(names.size()) - 1);
    const auto other = choiceList(uiOf(app), "##segment", names, static_cast<int>(chosen));
    return other ? static_cast<uint>(*other) : chosen;
}

void drawSegments(App& app) {
    const Ui ui = uiOf(app);
    SegmentChoice& choice = app.session.segment;
    choice.shown = true;
    if (groomOf(app).body().empty()) {
        ImGui::TextWrapped(
            "This mesh has no body segments: nothing in its file names parts of it. Add a segment "
            "and paint the skin that belongs to it.");
    } else {
        caption(ui, "SEGMENTS AND THEIR VERTICES");
        count(choice, groomOf(app));
        choice.chosen = std::min(choice.chosen, static_cast<uint>(choice.vertices.size()) - 1);
        drawList(app);
    }
    drawBody(app);
    // What was pressed above may have removed the last segment.
    count(choice, groomOf(app));
    if (choice.vertices.empty()) return;
    choice.chosen = std::min(choice.chosen, static_cast<uint>(choice.vertices.size()) - 1);
    drawChosen(app);
}

}  // namespace pelage
