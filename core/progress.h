// progress.h -- how long work reports how far it is and learns that nobody wants it any more.
#pragma once

#include <atomic>
#include <stdexcept>

namespace pelage {

// Thrown by work that found `cancel` set. Nothing was changed.
struct Cancelled : std::runtime_error {
    Cancelled() : std::runtime_error("cancelled") {}
};

// Shared by the thread that works and the one that shows it.
struct Progress {
    std::atomic<float> done{0.0f};  // share of the work, [0,1]
    std::atomic<bool> cancel{false};

    // Called by the worker. Throws Cancelled.
    void report(float share) {
        done = share;
        if (cancel) throw Cancelled();
    }
};

}  // namespace pelage
