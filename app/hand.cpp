// hand.cpp -- what the left button begins, and the radius of the brush.
#include "app/hand.h"

#include <algorithm>
#include <string>
#include <utility>

#include "app/app.h"
#include "app/hand_strokes.h"
#include "core/gradient.h"
#include "core/pick.h"
#include "core/text.h"

namespace pelage {
namespace {

constexpr float kCornerStep = 3.0f;  // window units of the design between corners of a lasso

float designUnit(const App& app, float depth) {  // m of one, at this depth
    return app.theme.scale * worldPerUnit(app.session.camera, app.viewport, depth);
}

// The skin under a place of the window, or where there is none the place as far away as `near`.
vec3 worldAt(const App& app, vec2 at, vec3 near) {
    if (const auto hit = hitAt(app, at)) return hit->position;
    return inPlane(app, near, at);
}

void paintGradient(App& app) {
    const auto& path = app.viewport.path;
    const Hand& hand = app.session.hand;
    const auto tool = fieldOf(app.session.tool);
    if (!tool) return;
    Gradient gradient{.tool = *tool, .between = hand.between};
    gradient.from = worldAt(app, path.front(), app.skin().center());
    gradient.to = worldAt(app, path.back(), gradient.from);
    const Ramp& ramp = hand.ramps[static_cast<std::size_t>(*tool)];
    gradient.start = ramp.start;
    gradient.end = ramp.end;
    if (gradient.from == gradient.to)
        tell(app, "A gradient goes from one place to another: drag.");
    else
        fillGradient(app, gradient);
}

void takeLasso(App& app) {
    const Viewport& viewport = app.viewport;
    if (viewport.path.size() < 3)
        return tell(app, "A lasso needs an outline: drag around the hair.");
    const Camera& camera = app.session.camera;
    Region& region = app.session.region;
    region.where = Where::lasso;
    region.viewProjection = viewProjection(app);
    region.eye = camera.orthographic ? vec3(0.0f) : camera.eye();
    region.polygon.clear();
    for (const vec2 at : viewport.path) region.polygon.push_back(clipped(viewport, at));
    app.session.hand.job = Job::paint;
    const std::string corners = std::to_string(region.polygon.size());
    tell(app, "Lasso of " + corners + " corners: choose what to do with its hair.");
    trace(app, "lasso " + corners);
}

void takeCenter(App& app, vec2 at) {
    const auto hit = hitAt(app, at);
    if (!hit) return tell(app, "There is no skin there.");
    app.session.region.center = hit->position;
    app.session.hand.job = Job::paint;
    tell(app, "The region is around that place.");
    trace(app, "center");
}

}  // namespace

std::optional<Tool> fieldOf(Tool tool) {
    if (tool == Tool::cut) return Tool::length;
    return hasGradient(tool) ? std::optional(tool) : std::nullopt;
}

Brush brushInHand(const App& app, vec3 place, bool shift, bool control) {
    Brush brush = heldBrush(app.session, shift, control);
    if (!app.session.hand.screenRadius) return brush;
    const Camera& camera = app.session.camera;
    const float depth = glm::dot(place - camera.eye(), camera.forward());
    brush.radius = clampedRadius(app.skin(), app.session.hand.radius * designUnit(app, depth));
    return brush;
}

float radiusInUnit(const App& app) {
    return app.session.hand.screenRadius ? app.session.hand.radius : app.session.brush().radius;
}

void setRadiusInUnit(App& app, float radius) {
    if (app.session.hand.screenRadius)
        app.session.hand.radius = std::clamp(radius, kLeastScreenRadius, kMostScreenRadius);
    else
        setRadius(app.session, app.skin(), radius);
}

void scaleRadius(App& app, float factor) { setRadiusInUnit(app, factor * radiusInUnit(app)); }

float radiusAfterMoving(const App& app, float before, float moved) {
    if (app.session.hand.screenRadius) return before + moved / app.theme.scale;
    const float depth = app.viewport.hit ? app.viewport.hit->distance : app.session.camera.distance;
    return before + moved * worldPerUnit(app.session.camera, app.viewport, depth);
}

void chooseScreenRadius(App& app, bool screen) {
    Hand& hand = app.session.hand;
    if (screen == hand.screenRadius) return;
    const float unit = designUnit(app, app.session.camera.distance);
    const float radius = screen ? radiusInUnit(app) / unit : radiusInUnit(app) * unit;
    hand.screenRadius = screen;
    setRadiusInUnit(app, radius);
}

void pressHand(App& app, const PointerEvent& event) {
    Viewport& viewport = app.viewport;
    const Job job = app.session.hand.job;
    if (job == Job::center) return takeCenter(app, event.at);
    if (job == Job::paint) return pressStroke(app, event);
    viewport.drag = job == Job::gradient ? Drag::gradient : Drag::lasso;
    viewport.path = {event.at};
}

void moveHand(App& app, const PointerEvent& event) {
    Viewport& viewport = app.viewport;
    if (viewport.drag == Drag::gradient) {
        viewport.path = {viewport.path.front(), event.at};
    } else if (viewport.drag == Drag::lasso) {
        if (glm::distance(viewport.path.back(), event.at) >= kCornerStep * app.theme.scale)
            viewport.path.push_back(event.at);
    } else {
        moveStroke(app, event);
    }
}

void releaseHand(App& app, const PointerEvent& event) {
    switch (std::exchange(app.viewport.drag, Drag::none)) {
        case Drag::gradient:
            paintGradient(app);
            break;
        case Drag::lasso:
            takeLasso(app);
            break;
        case Drag::stroke:
            releaseStroke(app);
            break;
        case Drag::click:
            paintLine(app, event);
            break;
        case Drag::axis:
            commitPending(app);
            break;
        default:
            break;
    }
}

void takeTool(App& app, Tool tool) {
    app.session.tool = tool;
    if (!fieldOf(tool)) app.session.hand.job = Job::paint;
}

void pickValue(App& app) {
    if (app.isOpen()) app.workspace.follow();
    const auto tool = fieldOf(app.session.tool);
    const auto hit = hitAt(app, app.viewport.pointer);
    if (!tool || !hit)
        return tell(app, tool ? "There is no skin under the pointer to pick from."
                              : "This brush sets no value that could be picked.");
    const Picked picked = pickedAt(app.skin(), app.document().groom, *hit);
    Brush& brush = app.session.brush();
    std::string text;
    if (*tool == Tool::tint) {
        brush.color = glm::clamp(picked.fur.tint, vec3(0.0f), vec3(1.0f));
        brush.mode = Mode::add;
        text = floatText(picked.fur.tint.r) + ' ' + floatText(picked.fur.tint.g) + ' ' +
               floatText(picked.fur.tint.b);
    } else {
        const ToolInfo& info = toolInfo(*tool);
        const float most = info.greatest * (info.ofLength ? app.skin().size() : 1.0f);
        const float value = *tool == Tool::length    ? picked.fur.furLength
                            : *tool == Tool::density ? picked.fur.density
                                                     : picked.mask;
        brush.value = std::clamp(value, 0.0f, most);
        brush.mode = Mode::set;
        text = info.ofLength ? lengthText(value) : floatText(value);
        trace(app, std::string("picked ") + info.name + ' ' + floatText(value));
    }
    tell(app, std::string("Picked ") + toolInfo(*tool).name + ' ' + text);
}

void toggleJob(App& app, Job job) {
    Job& current = app.session.hand.job;
    current = current == job ? Job::paint : job;
}

}  // namespace pelage
