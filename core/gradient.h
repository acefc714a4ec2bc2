// gradient.h -- a ramp of values along a straight line, painted over the whole skin at once.
#pragma once

#include <string>

#include "brush.h"
#include "editor.h"
#include "script_text.h"

namespace pelage {

// The tool says what is painted: length, density, mask or tint.
struct Gradient {
    Tool tool = Tool::length;
    vec3 from{0.0f}, to{0.0f};    // m, world; not the same point
    vec3 start{0.0f}, end{1.0f};  // of tint linear RGB; else in x: m for length, otherwise [0,1]
    bool between = false;  // only skin between the planes through the ends; otherwise what lies
                           // beyond an end has that end's value
};

// True for the tools that a gradient can paint with.
bool hasGradient(Tool tool);

// Each vertex takes the value at the point of the line nearest to it. The painted mask holds back
// as it does from a brush, but not where the mask is painted.
void applyGradient(const Skin& skin, Groom& groom, const Gradient& gradient);

// "gradient length from 0 0 0 0.1 to 0 1 0 0.01"; with "between" before "from". A tint has three
// numbers in place of the one after each point.
std::string gradientLine(const Gradient& gradient);

// Runs what follows the first word of such a line, as one step of history. `skin` is the editor's
// as it stands. Throws std::runtime_error with what is wrong in the line; the document is then as
// before it.
void runGradient(const Skin& skin, Editor& editor, Words& words);

}  // namespace pelage
