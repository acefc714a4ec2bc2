// region_panel.cpp -- where to edit all hair at once, and what to do with it.
#include <span>
#include <string>
#include <vector>

#include "app/actions.h"
#include "app/panels/panels.h"
#include "core/body.h"

namespace pelage {
namespace {

// A number of the region that is kept in sizes of the skin and shown in metres or the like.
void sizeRow(App& app, const char* label, float& sizes, float greatest, const char* help) {
    const LengthUnit unit = unitFor(app.skin().size());
    const float scale = app.skin().size() * unit.perMetre;
    const std::string format = numberFormat(unit);
    if (const auto value = numberRow(uiOf(app), label, sizes * scale,
                                     {.greatest = greatest * scale,
                                      .fallback = 0.1f * greatest * scale,
                                      .format = format.c_str(),
                                      .help = help}))
        sizes = *value / scale;
}

void drawCenter(App& app, Region& region) {
    const Skin& skin = app.skin();
    const LengthUnit unit = unitFor(skin.size());
    const std::string format = numberFormat(unit);
    constexpr const char* kAxes[] = {"Centre X", "Centre Y", "Centre Z"};
    for (int i = 0; i < 3; ++i)
        if (const auto value = numberRow(uiOf(app), kAxes[i], region.center[i] * unit.perMetre,
                                         {.least = skin.lower[i] * unit.perMetre,
                                          .greatest = skin.upper[i] * unit.perMetre,
                                          .fallback = skin.center()[i] * unit.perMetre,
                                          .format = format.c_str(),
                                          .help = "Middle of the region in the world."}))
            region.center[i] = *value / unit.perMetre;
}

// Begins a job of the left button, or gives it up.
void jobButton(App& app, const char* label, Job job, const char* help) {
    const bool on = app.session.hand.job == job;
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, color::kAccentDeep);
    if (plainButton(uiOf(app), label, ImGui::GetContentRegionAvail().x)) toggleJob(app, job);
    if (on) ImGui::PopStyleColor();
    tip(uiOf(app), help);
}

// Which segment; false when there is none.
bool drawSegments(App& app, Region& region) {
    const std::span<const Segment> body = app.document().groom.body();
    if (body.empty()) {
        ImGui::TextDisabled("This animal has no segments.");
        return false;
    }
    uint chosen = 0;
    for (uint s = 0; s < body.size(); ++s)
        if (nameOfSegment(body, s) == region.segment) chosen = s;
    region.segment = nameOfSegment(body, segmentRow(app, chosen));
    return true;
}

// Where; false when there is no such place on this animal.
bool drawWhere(App& app, Region& region) {
    const Ui ui = uiOf(app);
    // In the order of Where.
    constexpr const char* kPlaces[] = {"Everywhere",   "Sphere",      "Box",         "Body segment",
                                       "Painted mask", "Narrow skin", "Curved skin", "Lasso"};
    if (const auto other = choiceList(ui, "##where", kPlaces, static_cast<int>(region.where)))
        region.where = static_cast<Where>(*other);
    tip(ui, "The part of the skin whose hair is edited.");
    bool possible = true;
    if (region.where == Where::sphere || region.where == Where::box) {
        drawCenter(app, region);
        jobButton(app, "Pick on the skin", Job::center,
                  "The next click on the skin is the middle of the region.");
    }
    if (region.where == Where::lasso) {
        possible = region.polygon.size() > 2;
        jobButton(app, possible ? "Draw another lasso" : "Draw a lasso", Job::lasso,
                  "Drag around hair on the picture; hair that faces away is left alone.");
    }
    if (region.where == Where::sphere)
        sizeRow(app, "Radius", region.radius, 1.0f, "Radius of the sphere.");
    if (region.where == Where::box) {
        sizeRow(app, "Half X", region.half.x, 1.0f, "Half of the box along x.");
        sizeRow(app, "Half Y", region.half.y, 1.0f, "Half of the box along y.");
        sizeRow(app, "Half Z", region.half.z, 1.0f, "Half of the box along z.");
    }
    if (region.where == Where::segment) possible = drawSegments(app, region);
    if (region.where == Where::narrow)
        sizeRow(app, "Thinner than", region.width, 0.3f,
                "Thickness of the body below the skin: ears, fingers, tail.");
    if (region.where == Where::curved) {
        if (const auto value = numberRow(ui, "Above", region.curvature,
                                         {.greatest = 100.0f,
                                          .fallback = 10.0f,
                                          .format = "%.1f / size",
                                          .help = "Mean curvature, out or in: size of the animal "
                                                  "over radius."}))
            region.curvature = *value;
    }
    if (region.where == Where::all) return true;
    if (region.where == Where::lasso) {
        if (const auto value = numberRow(ui, "Falloff", region.falloff,
                                         {.greatest = 0.5f,
                                          .format = "%.2f",
                                          .help = "Width over which the effect fades outside, in "
                                                  "halves of the picture's height."}))
            region.falloff = *value;
    } else if (region.where != Where::curved) {
        sizeRow(app, "Falloff", region.falloff, 0.3f, "Width over which the effect fades outside.");
    } else if (const auto value = numberRow(ui, "Falloff", region.falloff,
                                            {.greatest = 100.0f,
                                             .format = "%.1f / size",
                                             .help = "Curvature over which the effect fades."})) {
        region.falloff = *value;
    }
    return possible;
}

float firstValue(const App& app, const RegionEdit& change) {
    switch (change.act) {
        case RegionAct::scale:
            return 0.5f;
        case RegionAct::set:
            return change.channel == Channel::length ? firstLength(app.skin()) : 1.0f;
        case RegionAct::smooth:
            return 1.0f;
        case RegionAct::randomise:
            return 0.3f;
    }
    return 1.0f;
}

void drawValue(App& app, RegionEdit& change) {
    const Ui ui = uiOf(app);
    if (change.act == RegionAct::set && change.channel == Channel::direction) {
        constexpr const char* kAxes[] = {"To X", "To Y", "To Z"};
        for (int i = 0; i < 3; ++i)
            if (const auto value = numberRow(
                    ui, kAxes[i], change.direction[i],
                    {.least = -1.0f,
                     .format = "%.2f",
                     .help = "Direction in the world, laid onto the skin. All zero: upright."}))
                change.direction[i] = *value;
        return;
    }
    const bool length = change.act == RegionAct::set && change.channel == Channel::length;
    const LengthUnit unit = unitFor(app.skin().size());
    const float scale = length ? unit.perMetre : 1.0f;
    const std::string format = length ? numberFormat(unit) : "%.2f";
    constexpr const char* kLabels[] = {"Factor", "Value", "Share", "Share"};
    const float greatest = length                           ? 0.5f * app.skin().size() * scale
                           : change.act == RegionAct::scale ? 4.0f
                                                            : 1.0f;
    if (const auto value =
            numberRow(ui, kLabels[static_cast<std::size_t>(change.act)], change.value * scale,
                      {.greatest = greatest,
                       .fallback = firstValue(app, change) * scale,
                       .format = format.c_str(),
                       .help = "How much, in the middle of the region."}))
        change.value = *value / scale;
    if (change.act != RegionAct::randomise) return;
    if (const auto seed = numberRow(
            ui, "Seed", static_cast<float>(change.seed),
            {.greatest = 1000.0f, .format = "%.0f", .help = "Another number, another draw."}))
        change.seed = static_cast<uint>(*seed + 0.5f);
}

void drawWhat(App& app, RegionEdit& change) {
    const Ui ui = uiOf(app);
    const RegionEdit before = change;
    constexpr const char* kChannels[] = {"Length", "Density", "Direction"};
    constexpr Channel kOrder[] = {Channel::length, Channel::density, Channel::direction};
    int channel = 0;
    for (int i = 0; i < 3; ++i)
        if (kOrder[i] == change.channel) channel = i;
    if (const auto other = choiceRow(ui, "channel", kChannels, channel))
        change.channel = kOrder[*other];
    constexpr const char* kActs[] = {"Scale", "Set", "Smooth", "Randomise"};
    rowLabel(ui, "Operation");
    if (const auto other = choiceList(ui, "##act", kActs, static_cast<int>(change.act)))
        change.act = static_cast<RegionAct>(*other);
    if (change.act != before.act || change.channel != before.channel)
        change.value = firstValue(app, change);
    drawValue(app, change);
}

}  // namespace

void drawRegions(App& app) {
    const Ui ui = uiOf(app);
    app.session.regionShown = true;
    caption(ui, "WHERE");
    const bool possible = drawWhere(app, app.session.region);
    caption(ui, "WHAT");
    drawWhat(app, app.session.regionEdit);
    ImGui::Dummy({0, app.theme.px(4)});
    ImGui::BeginDisabled(!possible);
    if (primaryButton(ui, "Apply", ImGui::GetContentRegionAvail().x)) editRegion(app);
    tip(ui, "Edits the hair of the region. A step that can be undone.");
    const Action& mask = actionNamed("mask.region");
    if (plainButton(ui, "Mask the region", ImGui::GetContentRegionAvail().x)) perform(app, mask);
    tip(ui, mask.help);
    ImGui::EndDisabled();
}

}  // namespace pelage
