// log_axis.h -- a logarithmic axis of a plot: where values stand, and which of them are named.
#pragma once

#include <vector>

namespace pelage {

struct LogAxis {
    double from = 0.0, to = 0.0;         // places of its ends, in pixels or the like
    double least = 0.0, greatest = 0.0;  // values there; 0 while it holds none

    // What is not positive and finite has no place on such an axis.
    static bool hasPlace(double value);
    // Reaches to a value that has a place.
    void hold(double value);
    // Leaves room at both ends, so that the greatest is at least `ratio` times the least. An axis
    // that holds nothing is around 1.
    void widen(double ratio);
    double place(double value) const;
    // Round values in growing order, no two places nearer than `apart`, and of the steps 1, 3; 1,
    // 2, 5 and so on the finest that allow it.
    std::vector<double> ticks(double apart) const;
};

}  // namespace pelage
