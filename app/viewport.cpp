// viewport.cpp -- pointer to camera and stroke.
#include "app/viewport.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/app.h"
#include "app/render/framing.h"
#include "app/segment_arrow.h"

namespace pelage {
namespace {

constexpr float kOrbitSpeed = 0.008f;  // rad per window unit
constexpr float kZoomSpeed = 0.006f;   // of dragging, per window unit
constexpr float kWheelStep = 1.15f;    // of the distance, per notch

bool within(const Viewport& viewport, vec2 at) {
    const vec2 local = at - viewport.corner;
    return local.x >= 0.0f && local.y >= 0.0f && local.x < viewport.size.x &&
           local.y < viewport.size.y;
}

void orbit(Camera& camera, vec2 moved) {
    constexpr float kQuarter = 0.5f * std::numbers::pi_v<float>;
    camera.yaw = std::remainder(camera.yaw - kOrbitSpeed * moved.x, 4.0f * kQuarter);
    camera.pitch = std::clamp(camera.pitch + kOrbitSpeed * moved.y, -kQuarter, kQuarter);
}

void pan(Camera& camera, const Viewport& viewport, vec2 moved) {
    const float step = worldPerUnit(camera, viewport, camera.distance);
    camera.target += step * (moved.y * camera.up() - moved.x * camera.right());
}

// Nearer or farther by a factor; what is under `at`, in the plane of the target, stays there.
void zoom(App& app, float factor, vec2 at) {
    Camera& camera = app.session.camera;
    const float size = app.skin().size();
    const float distance = std::clamp(camera.distance * factor, 0.02f * size, 50.0f * size);
    const vec2 place = clipped(app.viewport, at);
    const float half = 0.5f * worldPerUnit(camera, app.viewport, camera.distance);
    const vec3 offset = half * (place.x * app.viewport.size.x * camera.right() +
                                place.y * app.viewport.size.y * camera.up());
    camera.target += (1.0f - distance / camera.distance) * offset;
    camera.distance = distance;
}

// The left button is down for something that a right click gives up.
bool handBusy(Drag drag) {
    return drag == Drag::stroke || drag == Drag::click || drag == Drag::gradient ||
           drag == Drag::lasso || drag == Drag::axis;
}

void press(App& app, const PointerEvent& event) {
    Viewport& viewport = app.viewport;
    if (viewport.drag == Drag::radius || viewport.drag == Drag::strength) {
        if (event.button == 1) cancelDrag(app);
        viewport.drag = Drag::none;  // the left button keeps the value
        return;
    }
    if (handBusy(viewport.drag)) {
        if (event.button == 1) cancelDrag(app);
        return;
    }
    if (viewport.drag != Drag::none || !app.isOpen()) return;
    viewport.dragStart = event.at;
    const bool left = event.button == 0, right = event.button == 1, middle = event.button == 2;
    if (event.alt)
        viewport.drag = left ? Drag::orbit : middle ? Drag::pan : right ? Drag::zoom : Drag::none;
    else if (middle)
        viewport.drag = event.shift ? Drag::pan : event.control ? Drag::zoom : Drag::orbit;
    else if (left && grabAxis(app, event.at))
        viewport.drag = Drag::axis;
    else if (left)
        pressHand(app, event);
    else if (right)
        app.session.hand.job = Job::paint;
}

void move(App& app, const PointerEvent& event, vec2 before) {
    Viewport& viewport = app.viewport;
    const vec2 moved = event.at - before;
    Camera& camera = app.session.camera;
    switch (viewport.drag) {
        case Drag::none:
            break;
        case Drag::stroke:
        case Drag::click:
        case Drag::gradient:
        case Drag::lasso:
            moveHand(app, event);
            break;
        case Drag::axis:
            dragAxis(app, event.at, event.control);
            break;
        case Drag::orbit:
            orbit(camera, moved);
            break;
        case Drag::pan:
            pan(camera, viewport, moved);
            break;
        case Drag::zoom:
            zoom(app, std::exp(kZoomSpeed * (moved.y - moved.x)), viewport.dragStart);
            break;
        case Drag::radius:
            setRadiusInUnit(
                app, radiusAfterMoving(app, viewport.dragValue, event.at.x - viewport.dragStart.x));
            break;
        case Drag::strength:
            setStrength(app.session,
                        viewport.dragValue + 0.005f * (event.at.x - viewport.dragStart.x));
            break;
    }
}

void release(App& app, const PointerEvent& event) {
    Viewport& viewport = app.viewport;
    if (handBusy(viewport.drag) && event.button == 0) releaseHand(app, event);
    const bool view =
        viewport.drag == Drag::orbit || viewport.drag == Drag::pan || viewport.drag == Drag::zoom;
    if (view) viewport.drag = Drag::none;
}

}  // namespace

vec2 clipped(const Viewport& viewport, vec2 at) {
    const vec2 share = (at - viewport.corner) / viewport.size;
    return {2.0f * share.x - 1.0f, 1.0f - 2.0f * share.y};
}

mat4 viewProjection(const App& app) {
    const Camera& camera = app.session.camera;
    const vec2 size = app.viewport.size;
    return camera.projection(size.x / size.y, app.skin().center(), modelRadius(app.skin())) *
           camera.view();
}

std::optional<vec2> placeOf(const App& app, vec3 world) {
    const vec4 clip = viewProjection(app) * vec4(world, 1.0f);
    if (!(clip.w > 0.0f)) return std::nullopt;
    const vec2 share(0.5f + 0.5f * clip.x / clip.w, 0.5f - 0.5f * clip.y / clip.w);
    return app.viewport.corner + share * app.viewport.size;
}

vec3 inPlane(const App& app, vec3 through, vec2 at) {
    const PointerRay ray = pointerRay(app.session.camera, app.viewport, at);
    const vec3 forward = app.session.camera.forward();
    const float along = glm::dot(through - ray.origin, forward) / glm::dot(ray.direction, forward);
    return ray.origin + along * ray.direction;
}

View viewAtRest(const App& app) {
    const Viewport& viewport = app.viewport;
    const ViewOptions& options = app.session.view;
    View view;
    view.camera = app.session.camera;
    view.size = {static_cast<int>(std::lround(viewport.size.x * viewport.pixels)),
                 static_cast<int>(std::lround(viewport.size.y * viewport.pixels))};
    view.overlay = options.overlay;
    view.showSkin = options.showSkin;
    view.showOver = options.showOver;
    view.showUnder = options.showUnder;
    view.shells = Shells::swept;
    view.over = options.over;
    view.under = options.under;
    view.layers = static_cast<uint>(options.layers);
    view.shellShadows = options.shellShadows;
    view.segments = static_cast<uint>(options.segments);
    view.seconds = options.windSeconds;
    view.detail = options.detail;
    view.detail.milliseconds = 0.0f;
    view.samples = options.samples;
    if (app.isOpen())
        for (std::size_t coat = 0; coat < view.maps.size(); ++coat) {
            const auto& [recipe, picture, layers, preview] = app.shells.coats[coat];
            view.maps[coat] = shellSource(picture, recipe, layers, app.skin().size());
            if (picture.texture) (coat == 0 ? view.over : view.under) = DrawnAs::shells;
        }
    view.posed = app.workspace.posed;
    view.background = kBackground;
    return view;
}

std::optional<SkinHit> hitAt(const App& app, vec2 at) {
    if (!app.isOpen()) return std::nullopt;
    const PointerRay ray = pointerRay(app.session.camera, app.viewport, at);
    return app.workspace.query->cast(ray.origin, ray.direction);
}

float worldPerUnit(const Camera& camera, const Viewport& viewport, float distance) {
    const float depth = camera.orthographic ? camera.distance : distance;
    return 2.0f * depth * std::tan(0.5f * camera.fieldOfView) / std::max(viewport.size.y, 1.0f);
}

PointerRay pointerRay(const Camera& camera, const Viewport& viewport, vec2 at) {
    const vec2 place = clipped(viewport, at);
    const float half = std::tan(0.5f * camera.fieldOfView);
    const vec3 across = place.x * half * viewport.size.x / viewport.size.y * camera.right() +
                        place.y * half * camera.up();
    if (!camera.orthographic) return {camera.eye(), glm::normalize(camera.forward() + across)};
    // Start far enough back that nothing near the target is behind the start.
    constexpr float kBack = 100.0f;
    return {camera.target + camera.distance * (across - kBack * camera.forward()),
            camera.forward()};
}

void usePointer(App& app, bool mine) {
    Viewport& viewport = app.viewport;
    const auto events = std::exchange(viewport.events, {});
    for (const PointerEvent& event : events) {
        const vec2 before = std::exchange(viewport.pointer, event.at);
        viewport.inside = mine && within(viewport, event.at);
        viewport.shift = event.shift;
        viewport.control = event.control;
        switch (event.kind) {
            case PointerKind::move:
                move(app, event, before);
                break;
            case PointerKind::press:
                if (viewport.inside || viewport.drag != Drag::none) press(app, event);
                break;
            case PointerKind::release:
                release(app, event);
                break;
            case PointerKind::wheel:
                if (viewport.inside && app.isOpen())
                    zoom(app, std::pow(kWheelStep, -event.wheel), event.at);
                break;
        }
    }
    viewport.inside = mine && within(viewport, viewport.pointer);
    // While a value is set by moving, the ring stays where the hand began.
    if (viewport.drag == Drag::radius || viewport.drag == Drag::strength) return;
    const bool stroke = viewport.drag == Drag::stroke;
    const bool free = viewport.inside && viewport.drag == Drag::none;
    if (viewport.drag != Drag::axis) hoverAxis(app, free);
    const bool brush = stroke || (free && !viewport.axisEnd);
    viewport.hit = brush ? hitAt(app, stroke ? viewport.brushAt : viewport.pointer) : std::nullopt;
}

void beginAdjust(App& app, Drag what) {
    Viewport& viewport = app.viewport;
    if (viewport.drag != Drag::none) return;
    viewport.drag = what;
    viewport.dragStart = viewport.pointer;
    viewport.dragValue = what == Drag::radius ? radiusInUnit(app) : app.session.brush().strength;
}

bool cancelDrag(App& app) {
    Viewport& viewport = app.viewport;
    const Drag was = std::exchange(viewport.drag, Drag::none);
    if (was == Drag::stroke) cancelStroke(app);
    if (was == Drag::axis) cancelPending(app);
    if (was == Drag::radius) setRadiusInUnit(app, viewport.dragValue);
    if (was == Drag::strength) setStrength(app.session, viewport.dragValue);
    if (was != Drag::none) return true;
    return std::exchange(app.session.hand.job, Job::paint) != Job::paint;
}

}  // namespace pelage
