// pareto.h -- which of many choices are worth their time.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace pelage {

struct Cost {
    double time = 0.0, error = 0.0;
};

// The numbers of the costs that no other one beats, from the fastest to the slowest. One beats
// another when it is no slower and no less exact, and better in one of both; of equal ones the
// first counts. What is not finite is left out.
std::vector<std::size_t> paretoFront(std::span<const Cost> costs);

}  // namespace pelage
