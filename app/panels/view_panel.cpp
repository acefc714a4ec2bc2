// view_panel.cpp -- what is drawn and how much of it; nothing here is saved or undone.
#include <algorithm>
#include <array>

#include "app/panels/panels.h"

namespace pelage {

namespace {

std::optional<DrawnAs> techniqueRow(const Ui& ui, const char* label, DrawnAs as, const char* help) {
    constexpr const char* kTechniques[] = {"Strands", "Shells", "Shells + fins", "Automatic"};
    ImGui::PushID(label);
    rowLabel(ui, label);
    const auto other = choiceList(ui, "##technique", kTechniques, static_cast<int>(as));
    tip(ui, help);
    ImGui::PopID();
    if (!other) return std::nullopt;
    return static_cast<DrawnAs>(*other);
}

void drawTechniques(const Ui& ui, ViewOptions& view, vec2 inShells) {
    if (const auto as = techniqueRow(ui, "Overcoat", view.over,
                                     "Strands are single hairs. Shells are layers of the same "
                                     "hairs; they leave out clumps, curls and frizz. Fins are "
                                     "hairs on the edges of the silhouette. Automatic "
                                     "fades to shells where nobody sees it and they cost less."))
        view.over = *as;
    if (const auto as = techniqueRow(ui, "Undercoat", view.under,
                                     "Strands over an undercoat of shells are one picture."))
        view.under = *as;
    if (view.over == DrawnAs::strands && view.under == DrawnAs::strands) return;
    if (const auto layers =
            numberRow(ui, "Layers", static_cast<float>(view.layers),
                      {.least = 0,
                       .greatest = 256,
                       .fallback = 0,
                       .format = view.layers == 0 ? "automatic" : "%.0f",
                       .help = "Of shells, at least; 0 takes as many as the picture needs."}))
        view.layers = static_cast<int>(*layers + 0.5f);
    toggleRow(ui, "Shell shadows", &view.shellShadows,
              "Single hairs in shells cast shadows on hair below them.");
    if (view.over == DrawnAs::automatic || view.under == DrawnAs::automatic)
        ImGui::TextDisabled("in shells: %.0f %% of overcoat, %.0f %% of undercoat",
                            100.0 * static_cast<double>(inShells.x),
                            100.0 * static_cast<double>(inShells.y));
}

// How many hairs, asked and achieved.
void drawDetail(const Ui& ui, Detail& detail, const FrameStats& stats) {
    std::array<const char*, kDetailRules.size()> rules{};
    std::ranges::transform(kDetailRules, rules.begin(), &DetailRule::label);
    ImGui::SetNextItemWidth(-1);
    if (const auto other = choiceList(ui, "##detail", rules, static_cast<int>(detail.rule))) {
        detail.rule = static_cast<Detail::Rule>(*other);
        detail.limit = ruleOf(detail).fallback;
    }
    const DetailRule& rule = ruleOf(detail);
    tip(ui, rule.help);
    if (rule.format)
        if (const auto limit = numberRow(ui, rule.label, detail.limit,
                                         {.least = rule.least,
                                          .greatest = rule.greatest,
                                          .fallback = rule.fallback,
                                          .format = rule.format,
                                          .logarithmic = true,
                                          .help = rule.help}))
            detail.limit = *limit;
    if (const auto time =
            numberRow(ui, "While moving", detail.milliseconds,
                      {.least = 10,
                       .greatest = 500,
                       .fallback = 45,
                       .format = "%.0f ms",
                       .logarithmic = true,
                       .help = "Time that one frame may take while you paint or turn the animal; "
                               "it is drawn more coarsely to keep it."}))
        detail.milliseconds = *time;
    if (stats.inShells != vec2(0.0f))
        ImGui::TextDisabled("%.0f ms, %.0f of them for shells", 1e3 * stats.seconds,
                            1e3 * stats.shellSeconds);
    else
        ImGui::TextDisabled("%.0f ms, %.0f %% of the hairs", 1e3 * stats.seconds,
                            100.0 * static_cast<double>(stats.hairsTried) /
                                static_cast<double>(std::max<std::size_t>(stats.hairsTotal, 1)));
    if (stats.deviation > 0.0f)
        ImGui::TextDisabled("to keep to %s up to %.2g pixels off",
                            detail.rule == Detail::Rule::flip ? "this" : "its time",
                            static_cast<double>(stats.deviation));
    if (detail.rule == Detail::Rule::flip)
        ImGui::TextDisabled("FLIP %.3f asked, %.3f %s", static_cast<double>(detail.limit),
                            static_cast<double>(stats.flip),
                            stats.flipMeasured ? "measured" : "expected");
}

}  // namespace

void drawView(App& app) {
    const Ui ui = uiOf(app);
    ViewOptions& view = app.session.view;
    caption(ui, "SHOW");
    toggleRow(ui, "Skin", &view.showSkin, "The surface that the hair grows on.");
    toggleRow(ui, "Overcoat", &view.showOver, "The long guard hairs.");
    toggleRow(ui, "Undercoat", &view.showUnder, "The short, dense hair below them.");

    drawMorphTargets(app);

    caption(ui, "OVERLAY");
    constexpr const char* kOverlays[] = {"None",      "Length", "Density",
                                         "Direction", "Mask",   "Segments"};
    ImGui::SetNextItemWidth(-1);
    if (const auto other = choiceList(ui, "##overlay", kOverlays, static_cast<int>(view.overlay)))
        view.overlay = static_cast<Overlay>(*other);

    caption(ui, "TECHNIQUE");
    drawTechniques(ui, view, app.stats.inShells);

    caption(ui, "HAIRS");
    if (const auto segments =
            numberRow(ui, "Segments", static_cast<float>(view.segments),
                      {.least = 1,
                       .greatest = 16,
                       .fallback = 8,
                       .format = "%.0f",
                       .help = "Straight pieces of one hair. Short fur needs two or three."}))
        view.segments = static_cast<int>(*segments + 0.5f);
    drawDetail(ui, view.detail, app.stats);
    toggleRow(ui, "Play wind", &view.playWind,
              "The wind of the coat panel blows; the picture never rests.");

    ImGui::Dummy({0, app.theme.px(3)});
    drawShells(app);

    caption(ui, "PICTURE");
    if (const auto samples =
            numberRow(ui, "Samples", static_cast<float>(view.samples),
                      {.least = 1,
                       .greatest = 256,
                       .fallback = 16,
                       .format = "%.0f",
                       .logarithmic = true,
                       .help = "Frames that the resting picture averages: smoother edges, softer "
                               "tips."}))
        view.samples = static_cast<int>(*samples + 0.5f);
    caption(ui, "CAMERA");
    toggleRow(ui, "Orthographic", &app.session.camera.orthographic,
              "No perspective: parallel lines stay parallel.");
    float degrees = glm::degrees(app.session.camera.fieldOfView);
    if (const auto field = numberRow(ui, "Field of view", degrees,
                                     {.least = 10,
                                      .greatest = 90,
                                      .fallback = 34.4f,
                                      .format = "%.0f\xC2\xB0",
                                      .help = "Vertical angle of the picture."}))
        app.session.camera.fieldOfView = glm::radians(*field);
    ImGui::Dummy({0, app.theme.px(6)});
    ImGui::PushFont(app.theme.small);
    ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
    ImGui::TextWrapped("%s", app.device.c_str());
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

}  // namespace pelage
