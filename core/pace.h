// pace.h -- how much work fits a frame: learns what work costs from the frames that were drawn.
#pragma once

namespace pelage {

class Pace {
public:
    // The work of a frame that should take so many seconds, with a little to spare; some work
    // always fits.
    double workWithin(double seconds) const;
    double secondsOf(double work) const;  // of a frame
    // From a frame whose parts were timed, s: its work, and what else it did.
    void learn(double work, double workSeconds, double restSeconds);

private:
    double perWork_ = 5e-8, rest_ = 0.02;  // s
};

}  // namespace pelage
