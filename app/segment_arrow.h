// segment_arrow.h -- the axes of the body segments over the picture, and how the hand moves one.
#pragma once

#include <vector>

#include "app/viewport.h"

namespace pelage {

// The color that a segment has in the overlay, linear RGB.
vec3 segmentColor(uint segment);

// Looks which end of the chosen axis the pointer can take hold of: none where it is not `free` or
// the list of segments is not on screen.
void hoverAxis(App& app, bool free);

// Takes hold of the end at a place in the window; false when there is none.
bool grabAxis(App& app, vec2 at);
// The end follows the hand in the plane that faces the eye; with `lengthOnly` along the axis.
void dragAxis(App& app, vec2 at, bool lengthOnly);
// Release and cancel are commitPending and cancelPending (app.h).

// Arrows from head to tail, the chosen one with discs to hold it by.
void addAxes(const App& app, std::vector<OverlayLine>& lines);

}  // namespace pelage
