// knobs.h -- the table of what `pelage measure` turns: ways to draw hair, and what each costs.
//
// A new way to draw joins by a row. A row takes one knob from its coarsest value to its finest; all
// else stays as measuredView and the coats have it.
#pragma once

#include <cstddef>
#include <span>

#include "app/render/renderer.h"

namespace pelage {

struct Technique {
    const char* name;  // in reports and on the command line
    const char* knob;  // what is turned
    bool ordered;      // each value is closer to the hair's true picture than the one before
    std::span<const char* const> values;
    void (*turn)(std::size_t value, Fur& fur, View& view);
    const char* leavesOut;  // what the picture lacks at the finest value
};

std::span<const Technique> techniques();

// Every hair, 16 segments of a polyline, the mean of 16 frames; camera and size are left to the
// caller.
View measuredView();

// How far the camera stands.
struct Nearness {
    const char* name;
    float share;  // of the distance that frames the model with its hair, see zoomed in framing.h
};
std::span<const Nearness> nearnesses();  // close 1/4, middle 1, far 6

}  // namespace pelage
