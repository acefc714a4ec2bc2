// milliseconds.h -- how long a piece of work takes.
#pragma once

#include <chrono>

namespace pelage::bench {

template <typename Work>
double milliseconds(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    return took.count();
}

}  // namespace pelage::bench
