// status_bar.cpp -- the numbers of the picture and the latest message.
#include <cstdio>
#include <string>

#include "app/panels/panels.h"

namespace pelage {
namespace {

// One number with its name, from right to left; returns the left end of what was drawn.
float field(App& app, float right, const std::string& value, const char* name, const char* help) {
    const float gap = app.theme.px(5);
    const float width = ImGui::CalcTextSize(value.c_str()).x + gap + ImGui::CalcTextSize(name).x;
    ImGui::SameLine(right - width);
    ImGui::BeginGroup();
    ImGui::TextUnformatted(value.c_str());
    ImGui::SameLine(0, gap);
    ImGui::TextDisabled("%s", name);
    ImGui::EndGroup();
    tip(uiOf(app), help);
    return right - width - app.theme.px(20);
}

}  // namespace

void drawStatus(App& app, const Layout& layout) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {app.theme.px(12), app.theme.px(4)});
    beginPanel("status", {0, layout.window.y - layout.status}, {layout.window.x, layout.status},
               ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    ImGui::PushFont(app.theme.small);
    float right = ImGui::GetWindowWidth() - app.theme.px(12);
    const float line = ImGui::GetCursorPosY();
    if (app.isOpen()) {
        char text[64];
        const FrameStats& stats = app.stats;
        std::snprintf(text, sizeof text, "%.1f", 1000.0 * stats.seconds);
        right =
            field(app, right, text, "ms", "Time of the last frame, to the end of the GPU's work.");
        std::snprintf(text, sizeof text, "%d/%d", stats.samples, app.session.view.samples);
        right =
            field(app, right, text, "samples", "Frames averaged in the resting picture so far.");
        right = field(app, right, grouped(stats.hairsDrawn) + " / " + grouped(stats.hairsTotal),
                      "hairs", "Hairs drawn in the last frame, of all that grow.");
        right =
            field(app, right, grouped(app.skin().triangles.size()), "triangles", "Of the skin.");
        const float distance = glm::length(app.session.camera.eye() - app.skin().center());
        right = field(app, right, lengthText(distance), "away",
                      "Distance from the eye to the middle of the animal.");
    }
    ImGui::SetCursorPos({app.theme.px(12), line});
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushClipRect({corner.x, corner.y - 10},
                        {ImGui::GetWindowPos().x + right, corner.y + app.theme.px(30)}, true);
    if (app.messageIsBad) {
        ImGui::PushStyleColor(ImGuiCol_Text, color::kBad);
        ImGui::TextUnformatted(app.message.c_str());
        ImGui::PopStyleColor();
    } else {
        ImGui::TextUnformatted(app.message.c_str());
    }
    ImGui::PopClipRect();
    ImGui::PopFont();
    ImGui::End();
}

}  // namespace pelage
