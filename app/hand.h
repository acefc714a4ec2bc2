// hand.h -- what the left button does on the picture: strokes, lines, gradients, lassos, places.
#pragma once

#include <array>
#include <optional>

#include "core/brush.h"

namespace pelage {

struct App;
struct PointerEvent;
struct Gradient;

// What the next press of the left button begins. A lasso and a centre are over when they are made.
enum class Job { paint, gradient, lasso, center };

// The values at the ends of a gradient, as in core/gradient.h.
struct Ramp {
    vec3 start{1.0f}, end{0.0f};
};

// How one person holds the brush; never undone.
struct Hand {
    Job job = Job::paint;
    float string = 0.0f;  // window units of the design by which the brush hangs behind the pointer
    bool screenRadius = false;           // the brush keeps its size on the screen, not on the skin
    float radius = 40.0f;                // window units of the design, when it does
    bool pen = true;                     // a pen's pressure scales the strength
    std::array<Ramp, kToolCount> ramps;  // by Tool
    bool between = false;                // a gradient leaves what lies beyond its ends
    std::optional<vec3> strokeEnd;       // m, world; where the last stroke ended
};

inline constexpr float kLongestString = 200.0f;                                // as Hand::string
inline constexpr float kLeastScreenRadius = 2.0f, kMostScreenRadius = 400.0f;  // as Hand::radius

// The tool whose field a gradient or the eyedropper works on with this brush; none for brushes that
// set no value.
std::optional<Tool> fieldOf(Tool tool);

// The brush that a press at this place of the skin starts: its radius there, and what held keys
// make of it.
Brush brushInHand(const App& app, vec3 place, bool shift, bool control);
// The radius larger by this factor, in the unit in which it is kept.
void scaleRadius(App& app, float factor);
// Where a value is set by moving: the radius in that unit, and as it is `moved` window units on.
float radiusInUnit(const App& app);
void setRadiusInUnit(App& app, float radius);
float radiusAfterMoving(const App& app, float before, float moved);
// Keeps the radius on the screen, or on the skin, as large as it is at the middle of the picture.
void chooseScreenRadius(App& app, bool screen);

// The left button went down on the picture, the pointer moved, it came up.
void pressHand(App& app, const PointerEvent& event);
void moveHand(App& app, const PointerEvent& event);
void releaseHand(App& app, const PointerEvent& event);

// Takes a brush; a job that it cannot do is over.
void takeTool(App& app, Tool tool);
// Takes the value under the pointer into the brush.
void pickValue(App& app);
// Begins a job, or goes back to painting when it was begun already.
void toggleJob(App& app, Job job);

// What the hand is about, over the picture: strings, lines, outlines, and a hint in words.
void drawHand(App& app);

}  // namespace pelage
