// hand_strokes.cpp -- strokes by hand: straight ones, steady ones, and how hard the hand presses.
#include "app/hand_strokes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/app.h"

namespace pelage {
namespace {

constexpr float kClick = 4.0f;  // window units of the design that a click may move
// Of the radius, between two looks at the skin under a line; within these window units.
constexpr float kLineStep = 0.25f, kLeastStep = 2.0f, kMostStep = 16.0f;

float pressureOf(App& app, const PointerEvent& event) {
    const float pen = app.session.hand.pen ? event.pressure : 1.0f;
    return pen * app.viewport.lightTouch.at(event.seconds, event.light);
}

void begin(App& app, const PointerEvent& event, vec2 at, const SkinHit& hit, bool shift) {
    Viewport& viewport = app.viewport;
    viewport.drag = Drag::stroke;
    viewport.brushAt = at;
    viewport.strokeAt = hit.position;
    viewport.lightTouch = HeldPressure(event.seconds, event.light);
    beginStroke(app, brushInHand(app, hit.position, shift, event.control), hit,
                pressureOf(app, event));
}

}  // namespace

void pressStroke(App& app, const PointerEvent& event) {
    const auto hit = hitAt(app, event.at);
    if (event.shift)
        app.viewport.drag = Drag::click;
    else if (hit)
        begin(app, event, event.at, *hit, false);
}

void moveStroke(App& app, const PointerEvent& event) {
    Viewport& viewport = app.viewport;
    if (viewport.drag == Drag::click) {
        const vec2 start = viewport.dragStart;
        if (glm::distance(start, event.at) <= kClick * app.theme.scale) return;
        const auto hit = hitAt(app, start);
        if (!hit) {
            viewport.drag = Drag::none;
            return;
        }
        begin(app, event, start, *hit, true);
    }
    const vec2 pull = event.at - viewport.brushAt;
    const float far = glm::length(pull), string = app.session.hand.string * app.theme.scale;
    if (!(far > string)) return;
    viewport.brushAt += (1.0f - string / far) * pull;
    const auto hit = hitAt(app, viewport.brushAt);
    if (!hit) return;
    app.workspace.drag(hit->position, hit->normal, pressureOf(app, event));
    viewport.strokeAt = hit->position;
    app.touched = true;
}

void releaseStroke(App& app) {
    app.session.hand.strokeEnd = app.viewport.strokeAt;
    endStroke(app);
}

void paintLine(App& app, const PointerEvent& event) {
    const auto& end = app.session.hand.strokeEnd;
    const auto start = end ? placeOf(app, *end) : std::nullopt;
    if (!start)
        return tell(app, end ? "The end of the last stroke is behind the eye."
                             : "Shift+click paints a line from the end of the last stroke; there "
                               "is none yet.");
    const float radius = brushInHand(app, *end, false, event.control).radius;
    const float unit = worldPerUnit(app.session.camera, app.viewport,
                                    glm::distance(*end, app.session.camera.eye()));
    const float step = std::clamp(kLineStep * radius / unit, kLeastStep, kMostStep);
    const int steps = std::max(1, static_cast<int>(glm::distance(*start, event.at) / step));
    for (int i = 0; i <= steps; ++i) {
        const vec2 at =
            glm::mix(*start, event.at, static_cast<float>(i) / static_cast<float>(steps));
        const auto hit = hitAt(app, at);
        if (!hit) continue;
        if (app.workspace.stroke)
            app.workspace.drag(hit->position, hit->normal, pressureOf(app, event));
        else
            begin(app, event, at, *hit, false);
        app.viewport.strokeAt = hit->position;
    }
    // Where skin was met, a stroke that did not begin has said why.
    const bool met = std::exchange(app.viewport.drag, Drag::none) == Drag::stroke;
    if (app.workspace.stroke)
        releaseStroke(app);
    else if (!met)
        tell(app, "The line misses the skin.");
}

}  // namespace pelage
