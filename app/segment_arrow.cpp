// segment_arrow.cpp -- arrows, their handles, and the plane in which a handle moves.
#include "app/segment_arrow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/app.h"
#include "core/segment_comb.h"

namespace pelage {
namespace {

constexpr float kDisc = 6.0f, kReach = 11.0f;  // radius in units of the design: seen, and felt
constexpr float kShortest = 1e-3f;             // of the skin's size
constexpr vec4 kAxis{0.62f, 0.93f, 1.0f, 0.95f};
constexpr vec4 kChosen{1.0f, 0.95f, 0.88f, 1.0f};
constexpr vec4 kHeld{1.0f, 0.55f, 0.15f, 1.0f};
constexpr vec4 kRim{0.0f, 0.0f, 0.0f, 0.6f};

vec3& endOf(Segment& segment, AxisEnd end) {
    return end == AxisEnd::root ? segment.root : segment.tip;
}

// The same place of the picture, before the body.
vec3 lifted(const App& app, vec3 p) {
    const Camera& camera = app.session.camera;
    const vec3 eye = camera.eye();
    const float size = app.skin().size();
    if (camera.orthographic) return p + size * glm::normalize(eye - camera.target);
    return glm::mix(p, eye, std::min(0.7f, size / std::max(glm::distance(p, eye), 1e-9f)));
}

void addDisc(const App& app, vec3 place, vec4 color, std::vector<OverlayLine>& lines) {
    constexpr int kSides = 20;
    const Camera& camera = app.session.camera;
    const vec3 center = lifted(app, place);
    const float depth = glm::dot(center - camera.eye(), camera.forward());
    const float unit = worldPerUnit(camera, app.viewport, depth);
    for (float radius = kDisc * app.theme.scale; radius > 0.5f; radius -= 0.8f) {
        const bool rim = radius > (kDisc - 1.0f) * app.theme.scale;
        vec3 before{0.0f};
        for (int i = 0; i <= kSides; ++i) {
            const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / kSides;
            const vec3 point =
                center +
                radius * unit * (std::cos(angle) * camera.right() + std::sin(angle) * camera.up());
            if (i > 0) lines.push_back({before, point, rim ? kRim : color});
            before = point;
        }
    }
}

// One unit wide, or for the chosen one two with a dark edge, so that it is seen on any color.
void addArrow(const App& app, const Segment& segment, bool chosen,
              std::vector<OverlayLine>& lines) {
    const Camera& camera = app.session.camera;
    const vec3 axis = segment.tip - segment.root;
    const vec3 across = glm::cross(axis, camera.eye() - segment.tip);
    const float width = glm::length(across);
    const vec3 side = width > 0.0f ? 0.12f * glm::length(axis) / width * across : vec3(0.0f);
    const auto add = [&](vec3 from) {
        const vec3 a = lifted(app, from), b = lifted(app, segment.tip);
        if (!chosen) return lines.push_back({a, b, kAxis});
        const float depth = glm::dot(b - camera.eye(), camera.forward());
        const vec3 aside = glm::cross(b - a, camera.forward());
        const float length = glm::length(aside);
        if (!(length > 0.0f)) return;
        const vec3 step =
            app.theme.scale * worldPerUnit(camera, app.viewport, depth) / length * aside;
        for (const float by : {-1.5f, 1.5f, -0.5f, 0.5f})
            lines.push_back({a + by * step, b + by * step, std::abs(by) > 1.0f ? kRim : kChosen});
    };
    add(segment.root);
    add(segment.tip - 0.25f * axis + side);
    add(segment.tip - 0.25f * axis - side);
}

const Segment* chosenOf(const App& app) {
    const std::span<const Segment> body = app.document().groom.body();
    const uint chosen = app.session.segment.chosen;
    return chosen < body.size() ? &body[chosen] : nullptr;
}

// While the list of segments is on screen, at rest, and the hand has no other job.
std::optional<AxisEnd> axisEndAt(const App& app, vec2 at) {
    const bool free = app.isOpen() && app.session.segment.shown && !app.workspace.posed &&
                      app.session.hand.job == Job::paint;
    const Segment* segment = free ? chosenOf(app) : nullptr;
    if (!segment) return std::nullopt;
    std::optional<AxisEnd> found;
    float nearest = kReach * app.theme.scale;
    for (const AxisEnd end : {AxisEnd::tip, AxisEnd::root}) {
        const auto place = placeOf(app, end == AxisEnd::tip ? segment->tip : segment->root);
        const float far = place ? glm::distance(*place, at) : nearest;
        if (!(far < nearest)) continue;
        nearest = far;
        found = end;
    }
    return found;
}

}  // namespace

// NOLINTBEGIN: the dialect is GLSL's.
using glm::abs, glm::clamp, glm::fract, glm::mix;
#include "shaders/segment_color.glsl"
// NOLINTEND

void hoverAxis(App& app, bool free) {
    const auto before = app.viewport.axisEnd;
    app.viewport.axisEnd = free ? axisEndAt(app, app.viewport.pointer) : std::nullopt;
    if (app.viewport.axisEnd != before && app.viewport.axisEnd)
        trace(app, app.viewport.axisEnd == AxisEnd::tip ? "in reach: tip" : "in reach: root");
}

bool grabAxis(App& app, vec2 at) {
    const auto end = axisEndAt(app, at);
    if (!end) return false;
    commitPending(app);
    Segment segment = *chosenOf(app);
    const vec3 place = endOf(segment, *end);
    app.viewport.axisEnd = end;
    app.viewport.axisGrip = inPlane(app, place, at) - place;
    return true;
}

void dragAxis(App& app, vec2 at, bool lengthOnly) {
    const Segment* chosen = chosenOf(app);
    if (!chosen || !app.viewport.axisEnd) return;
    Segment segment = *chosen;
    const bool atTip = *app.viewport.axisEnd == AxisEnd::tip;
    vec3& moved = endOf(segment, *app.viewport.axisEnd);
    const vec3 other = atTip ? segment.root : segment.tip;
    vec3 place = inPlane(app, moved, at) - app.viewport.axisGrip;
    if (lengthOnly) {
        const vec3 along = atTip ? axisOf(segment) : -axisOf(segment);
        place = other + std::max(glm::dot(place - other, along), 0.0f) * along;
    }
    if (!(glm::distance(place, other) > kShortest * app.skin().size())) return;
    moved = place;
    editAxis(app, app.session.segment.chosen, segment.root, segment.tip);
}

void addAxes(const App& app, std::vector<OverlayLine>& lines) {
    const Segment* chosen = chosenOf(app);
    for (const Segment& segment : app.document().groom.body())
        if (&segment != chosen && axisOf(segment) != vec3(0.0f))
            addArrow(app, segment, false, lines);
    if (!chosen) return;
    addArrow(app, *chosen, true, lines);
    const auto held = app.viewport.axisEnd;
    addDisc(app, chosen->root, held == AxisEnd::root ? kHeld : kChosen, lines);
    addDisc(app, chosen->tip, held == AxisEnd::tip ? kHeld : kChosen, lines);
}

}  // namespace pelage
