// flip_budget.h -- a FLIP that is asked for: how coarse the picture may be, and whether it kept it.
#pragma once

#include "core/fidelity.h"

namespace pelage {

class FlipBudget {
public:
    // Another picture is drawn.
    void begin() { refined_ = false; }
    // Pixels by which edges may be off in a view, which the other functions then speak of.
    float deviationWithin(float flip, const Roots& roots, const InSight& seen, const Sight& sight,
                          const Pelt& pelt, const Fineness& otherwise);
    float flipAt(float deviation) const { return fidelity_.flipAt(deviation, fur_); }
    double workOfAll() const { return workOfAll_; }  // hairs
    // From the error that a complete picture turned out to have. True where it is to be drawn anew:
    // it missed what was asked or left most of it unused.
    bool learn(float asked, float measured, float deviation);

private:
    Fidelity fidelity_;
    FurInView fur_;
    bool refined_ = false;  // the picture is drawn anew, as it had been too coarse
    double workOfAll_ = 0.0;
};

}  // namespace pelage
