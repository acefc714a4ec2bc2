// shape_error.h -- how far the shape of drawn hair strays from what it stands for.
//
// An error is the greatest distance between two hairs of length 1 at equal shares of their lengths.
#pragma once

#include <vector>

#include "types.h"

namespace pelage {

struct ShapeError {
    enum class Part {
        segments,  // hair drawn with so many straight segments, against its exact curve
        droop,     // the paper's rule, against the rod that it is like
        table,     // the table of rods, against the solver, at the middle of each of its cells
    } part;
    uint droop;     // of the hair: kDroop...
    uint segments;  // 0 = the curve itself
    double root;    // angle from up, rad
    double load;    // of the rod
    double error;
    bool used = true;  // false for cells of the table that no hair looks up
};

// All of them. Rods as hair is shaped: stiffer near upright (shaders/rod.glsl).
std::vector<ShapeError> shapeErrors();

// Of one hair: the rule of the paper at the floppiness that is like this load, at most 1; and the
// table of rods, for load <= kMostLoad.
double paperShapeError(double root, double load);
double tableShapeError(double root, double load);

}  // namespace pelage
