// view_panel.cpp -- what is drawn and how much of it; nothing here is saved or undone.
#include "app/panels/panels.h"

namespace pelage {

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

    caption(ui, "HAIRS");
    if (const auto segments =
            numberRow(ui, "Segments", static_cast<float>(view.segments),
                      {.least = 1,
                       .greatest = 16,
                       .fallback = 8,
                       .format = "%.0f",
                       .help = "Straight pieces of one hair. Short fur needs two or three."}))
        view.segments = static_cast<int>(*segments + 0.5f);
    if (const auto share = numberRow(ui, "Share drawn", view.share,
                                     {.least = 0.01f,
                                      .fallback = 1.0f,
                                      .format = "%.2f",
                                      .help = "At most this share of the hairs is drawn, each "
                                              "wider in the same proportion."}))
        view.share = *share;
    toggleRow(ui, "Fewer hairs far away", &view.cullByDistance,
              "The number of hairs falls with the distance (van Gelder and Wilhelms, 1997).");

    toggleRow(ui, "Play wind", &view.playWind,
              "The wind of the coat panel blows; the picture never rests.");

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
    if (const auto budget =
            numberRow(ui, "While moving", 1000.0f * view.budget,
                      {.least = 10,
                       .greatest = 500,
                       .fallback = 45,
                       .format = "%.0f ms",
                       .logarithmic = true,
                       .help = "Time that one frame may take while you paint or turn the animal; "
                               "fewer hairs are drawn to keep it."}))
        view.budget = 0.001f * *budget;

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
