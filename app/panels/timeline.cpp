// timeline.cpp -- which animation, where in it, how fast; and the weights of morph targets.
#include <string>
#include <vector>

#include "app/actions.h"
#include "app/panels/panels.h"

namespace pelage {
namespace {

// "Rest", then the clips.
void drawClips(App& app) {
    std::vector<const char*> names{"Rest"};
    for (const Clip& clip : app.rig()->clips) names.push_back(clip.name.c_str());
    ImGui::SetNextItemWidth(app.theme.px(130));
    if (const auto chosen = choiceList(uiOf(app), "##clip", names, app.workspace.pose.clip + 1)) {
        Pose pose = app.workspace.pose;
        pose.clip = *chosen - 1;
        pose.seconds = 0.0f;
        if (pose.clip < 0) app.session.playback.playing = false;
        stand(app, std::move(pose));
    }
    tip(uiOf(app), "The animation to stand in; strokes on it paint the rest pose.");
}

void drawScrubber(App& app, float width) {
    const Pose& now = app.workspace.pose;
    const bool clip = now.clip >= 0;
    float seconds = now.seconds;
    const float end = clip ? app.clipSeconds() : 1.0f;
    ImGui::BeginDisabled(!clip);
    ImGui::SetNextItemWidth(width);
    if (ImGui::SliderFloat("##time", &seconds, 0.0f, end, clip ? "%.2f s" : "",
                           ImGuiSliderFlags_AlwaysClamp)) {
        Pose pose = now;
        pose.seconds = seconds;
        app.session.playback.playing = false;
        stand(app, std::move(pose));
    }
    ImGui::EndDisabled();
    tip(uiOf(app), "The moment of the animation; drag to see others.");
}

}  // namespace

void drawTimeline(App& app, const Layout& layout) {
    if (layout.timeline == 0.0f) return;
    const Ui ui = uiOf(app);
    const float width = layout.window.x - layout.left - layout.right;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {app.theme.px(8), app.theme.px(3)});
    beginPanel("timeline", {layout.left, layout.window.y - layout.bottom() - layout.timeline},
               {width, layout.timeline}, ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    Playback& playback = app.session.playback;
    const Action& play = actionNamed("play.toggle");
    const float top = ImGui::GetCursorPosY();
    const char* icon = playback.playing ? icon::kPause : icon::kPlay;
    if (iconButton(ui, icon, playback.playing ? "Pause" : "Play", false, true)) perform(app, play);
    tip(ui, play.help);
    // The fields stand in the middle of the strip, beside the taller buttons.
    const float middle = 0.5f * (layout.timeline - ImGui::GetFrameHeight());
    const auto besides = [](float y) {
        ImGui::SameLine();
        ImGui::SetCursorPosY(y);
    };
    besides(middle);
    drawClips(app);
    besides(middle);
    const float speedWidth = app.theme.px(64), loopWidth = app.theme.px(42);
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    drawScrubber(app, ImGui::GetContentRegionAvail().x - speedWidth - loopWidth - 2 * gap);
    besides(middle);
    ImGui::SetNextItemWidth(speedWidth);
    if (const auto speed = numberBar(ui, "##speed", playback.speed,
                                     {.least = 0.1f,
                                      .greatest = 4.0f,
                                      .fallback = 1.0f,
                                      .format = "%.2fx",
                                      .logarithmic = true,
                                      .help = "How fast the animation plays."}))
        playback.speed = *speed;
    besides(top);
    if (iconButton(ui, icon::kLoop, "Loop", playback.loop, true)) playback.loop = !playback.loop;
    tip(ui, "Begin again at the end.");
    ImGui::End();
}

void drawMorphTargets(App& app) {
    const Rig* rig = app.rig();
    if (!rig || rig->targets.empty()) return;
    const Ui ui = uiOf(app);
    caption(ui, "MORPH TARGETS");
    std::vector<float> atRest;
    for (const MorphTarget& target : rig->targets) atRest.push_back(target.weight);
    Pose pose = app.workspace.pose;
    if (pose.weights.empty()) pose.weights = atRest;
    for (std::size_t t = 0; t < atRest.size(); ++t) {
        ImGui::PushID(static_cast<int>(t));
        if (const auto weight =
                numberRow(ui, rig->targets[t].name.c_str(), pose.weights[t],
                          {.fallback = atRest[t],
                           .format = "%.2f",
                           .help = "How far this shape is put on; only for looking and painting, "
                                   "it is not saved."}))
            pose.weights[t] = *weight;
        ImGui::PopID();
    }
    if (pose.weights == atRest) pose.weights.clear();
    stand(app, std::move(pose));
}

}  // namespace pelage
