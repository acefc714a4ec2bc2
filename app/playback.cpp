// playback.cpp -- the animal goes on from frame to frame, and holds still under the hand.
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/app.h"

namespace pelage {
namespace {

// A press of the painting hand.
bool mayPaint(const PointerEvent& event) {
    return event.kind == PointerKind::press && event.button == 0 && !event.alt;
}

}  // namespace

void stand(App& app, Pose pose) {
    if (!app.isOpen() || app.workspace.stroke || pose == app.workspace.pose) return;
    app.workspace.stand(std::move(pose));
    app.touched = true;
}

void playOrPause(App& app) {
    bool& playing = app.session.playback.playing;
    playing = !playing && !app.workspace.stroke;
    trace(app, playing ? "play" : "pause " + poseLine(app.workspace.pose));
    if (!playing) return;
    Pose pose = app.workspace.pose;
    const bool over =
        pose.clip >= 0 && !app.session.playback.loop && pose.seconds >= app.clipSeconds();
    if (pose.clip < 0 || over) pose.seconds = 0.0f;
    pose.clip = std::max(pose.clip, 0);
    stand(app, std::move(pose));
}

void playOn(App& app, float seconds) {
    Playback& playback = app.session.playback;
    if (!playback.playing || app.workspace.stroke) return;
    Pose pose = app.workspace.pose;
    const float end = app.clipSeconds();
    pose.seconds += playback.speed * seconds;
    if (pose.seconds >= end && playback.loop && end > 0.0f) {
        pose.seconds = std::fmod(pose.seconds, end);
    } else if (pose.seconds >= end) {
        pose.seconds = end;
        playback.playing = false;
    }
    stand(app, std::move(pose));
}

void meetPointer(App& app, bool mine) {
    if (!app.isOpen() || !mine) return;
    const bool playing = app.session.playback.playing;
    const std::vector<PointerEvent>& events = app.viewport.events;
    if (playing && std::ranges::none_of(events, mayPaint)) return;
    app.workspace.follow();
    const auto meets = [&](const PointerEvent& e) { return mayPaint(e) && hitAt(app, e.at); };
    if (playing && std::ranges::any_of(events, meets)) playOrPause(app);
}

}  // namespace pelage
