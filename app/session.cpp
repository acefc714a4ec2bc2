// session.cpp -- brush and camera habits.
#include "app/session.h"
#include "app/render/framing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pelage {

namespace {

constexpr vec3 kFirstTint{0.45f, 0.16f, 0.05f};  // chestnut: seen on every coat that is not black

}  // namespace

LengthUnit unitFor(float size) {
    if (size < 0.02f) return {"mm", 1000.0f};
    if (size < 20.0f) return {"cm", 100.0f};
    return {"m", 1.0f};
}

std::string numberFormat(LengthUnit unit) { return std::string("%.2f ") + unit.name; }

std::string lengthText(float metres) {
    const LengthUnit unit = unitFor(metres * 20.0f);
    char text[32];
    std::snprintf(text, sizeof text, "%.3g %s", static_cast<double>(metres * unit.perMetre),
                  unit.name);
    return text;
}

void frameAll(Session& session, const Skin& skin, float aspect) {
    const bool orthographic = session.camera.orthographic;
    session.camera =
        framed(skin.center(), modelRadius(skin), session.camera.yaw, session.camera.pitch, aspect);
    session.camera.orthographic = orthographic;
}

void turnTo(Session& session, float yaw, float pitch) {
    session.camera.yaw = yaw;
    session.camera.pitch = pitch;
}

float clampedRadius(const Skin& skin, float radius) {
    return std::clamp(radius, kSmallestRadius * skin.size(), kLargestRadius * skin.size());
}

void setRadius(Session& session, const Skin& skin, float radius) {
    for (Brush& brush : session.brushes) brush.radius = clampedRadius(skin, radius);
}

void setStrength(Session& session, float strength) {
    session.brush().strength = std::clamp(strength, 0.01f, 1.0f);
}

void setMirror(Session& session, int axis, bool on) {
    for (Brush& brush : session.brushes) brush.mirror[axis] = on;
}

void setAlongSurface(Session& session, bool on) {
    for (Brush& brush : session.brushes) brush.alongSurface = on;
}

void setFacingOnly(Session& session, bool on) {
    for (Brush& brush : session.brushes) brush.facingOnly = on;
}

void meetSkin(Session& session, const Skin& skin, float aspect) {
    for (const ToolInfo& info : tools()) {
        Brush& brush = session.brushes[static_cast<std::size_t>(info.tool)];
        brush.tool = info.tool;
        if (info.tool == Tool::length) brush.value = firstLength(skin);
        if (info.tool == Tool::cut) brush.value = 0.5f * firstLength(skin);
        if (!info.add && info.hasSet) brush.mode = Mode::set;
        if (info.tool == Tool::tint && brush.color == vec3(1.0f)) brush.color = kFirstTint;
        if (info.tool == Tool::density) brush.value = std::max(brush.value, 0.5f);
        if (info.tool == Tool::mask) brush.value = 1.0f;
    }
    setRadius(session, skin, kFirstRadius * skin.size());
    session.hand.job = Job::paint;
    session.hand.strokeEnd.reset();
    session.region.center = skin.center();
    const auto ramp = [&](Tool tool) -> Ramp& {
        return session.hand.ramps[static_cast<std::size_t>(tool)];
    };
    ramp(Tool::length) = {vec3(firstLength(skin)), vec3(0.25f * firstLength(skin))};
    ramp(Tool::tint) = {kFirstTint, vec3(1.0f)};
    session.segment = {};
    session.playback.playing = false;
    session.camera = Camera{};
    session.camera.yaw = 0.9f;  // from the animal's left shoulder, a little from above
    session.camera.pitch = 0.25f;
    frameAll(session, skin, aspect);
}

Brush heldBrush(const Session& session, bool shift, bool control) {
    Brush brush = session.brush();
    if (shift) {
        brush = session.brushes[static_cast<std::size_t>(Tool::smooth)];
        brush.strength = session.brush().strength;
    }
    if (control && brush.mode == Mode::add)
        brush.mode = Mode::subtract;
    else if (control && brush.mode == Mode::subtract)
        brush.mode = Mode::add;
    return brush;
}

}  // namespace pelage
