// viewport.h -- from pointer and wheel over the picture to camera moves and strokes.
#pragma once

#include <optional>
#include <vector>

#include "app/pressure.h"
#include "app/render/renderer.h"
#include "core/skin_query.h"

namespace pelage {

struct App;

enum class PointerKind { move, press, release, wheel };

struct PointerEvent {
    PointerKind kind = PointerKind::move;
    vec2 at{0.0f};   // window units
    int button = 0;  // 0 left, 1 right, 2 middle
    bool shift = false, control = false, alt = false;
    float wheel = 0.0f;     // notches, positive away from the hand
    float pressure = 1.0f;  // [0,1] of the pen; 1 without one
    bool light = false;     // the key for a light touch is held
    double seconds = 0.0;   // when
};

// `click`: Shift and the left button are down, and nothing has moved yet.
enum class Drag { none, stroke, click, gradient, lasso, axis, orbit, pan, zoom, radius, strength };
enum class AxisEnd { root, tip };  // of the arrow of a body segment

struct Viewport {
    vec2 corner{0.0f}, size{1.0f};        // window units, top left
    float pixels = 1.0f;                  // of the frame buffer per window unit
    std::vector<PointerEvent> events;     // since the last frame, in their order
    vec2 pointer{-1.0f};                  // window units
    bool shift = false, control = false;  // held now
    bool light = false;                   // the same, the key for a light touch
    bool inside = false;                  // the pointer is over the picture and nothing else
    Drag drag = Drag::none;
    vec2 dragStart{0.0f};
    float dragValue = 0.0f;  // radius or strength when the drag began
    std::vector<vec2> path;  // window units; of a lasso, or the ends of a gradient
    vec2 brushAt{0.0f};      // window units; where the brush is, behind the pointer
    vec3 strokeAt{0.0f};     // m, world; where the stroke is
    HeldPressure lightTouch;
    std::optional<SkinHit> hit;      // under the pointer
    std::optional<AxisEnd> axisEnd;  // under the pointer or held (segment_arrow.h)
    vec3 axisGrip{0.0f};             // m, from the end that is held to the hand
    std::vector<OverlayLine> lines;  // cursor and arrows, for View::lines
};

struct PointerRay {
    vec3 origin{0.0f}, direction{0.0f};  // world; direction is unit
};

// The ray through a point of the window.
PointerRay pointerRay(const Camera& camera, const Viewport& viewport, vec2 at);

// Where a place of the window is in the picture: [-1,1] both ways, y up.
vec2 clipped(const Viewport& viewport, vec2 at);
// Where a place in the world is in the window; nothing behind the eye.
std::optional<vec2> placeOf(const App& app, vec3 world);

// Where a place of the window is in the plane through a point that faces the eye.
vec3 inPlane(const App& app, vec3 through, vec2 at);
// From the world to clip space of the picture.
mat4 viewProjection(const App& app);
// The skin under a place of the window.
std::optional<SkinHit> hitAt(const App& app, vec2 at);

// What the window shows when the hand rests, without cursor and arrows.
View viewAtRest(const App& app);
inline constexpr vec3 kBackground{0.040f, 0.043f, 0.050f};  // linear RGB

// World length of one window unit at `distance` from the eye, across the line of sight.
float worldPerUnit(const Camera& camera, const Viewport& viewport, float distance);

// Carries out the events that arrived and empties the list. `mine` is false where a panel, a
// pop-up or a dialog has the pointer.
void usePointer(App& app, bool mine);

// Begins to set radius or strength by moving the pointer from where it is.
void beginAdjust(App& app, Drag what);
// Esc and right click: gives up what the pointer is dragging, or else the job that was chosen.
// False when there was neither.
bool cancelDrag(App& app);

// Rings under the pointer and arrows of the direction overlay.
void updateLines(App& app);

}  // namespace pelage
