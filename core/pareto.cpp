// pareto.cpp -- one pass over the costs from the fastest to the slowest.
#include "pareto.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pelage {

std::vector<std::size_t> paretoFront(std::span<const Cost> costs) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < costs.size(); ++i)
        if (std::isfinite(costs[i].time) && std::isfinite(costs[i].error)) order.push_back(i);
    std::ranges::sort(order, {},
                      [&](std::size_t i) { return std::tuple(costs[i].time, costs[i].error, i); });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
        if (front.empty() || costs[i].error < costs[front.back()].error) front.push_back(i);
    return front;
}

}  // namespace pelage
