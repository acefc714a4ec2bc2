// flip_budget.cpp -- pictures that get finer until they keep their error.
#include "app/render/flip_budget.h"

#include <algorithm>

namespace pelage {
namespace {

constexpr float kLeastUse = 0.6f;  // share of an error that is asked for

}  // namespace

float FlipBudget::deviationWithin(float flip, const Roots& roots, const InSight& seen,
                                  const Sight& sight, const Pelt& pelt, const Fineness& otherwise) {
    fur_ = furInView(roots, seen, sight, pelt);
    workOfAll_ = workOf(seen, sight, pelt, {.rule = Detail::Rule::all}, 0.0f, otherwise);
    // All hairs are not the first try: it would tell nothing of the error of fewer.
    return std::max(fidelity_.deviationWithin(flip, fur_), refined_ ? 0.0f : kFinest);
}

bool FlipBudget::learn(float asked, float measured, float deviation) {
    const bool missed = measured > asked;
    const bool wastes = !refined_ && measured < kLeastUse * asked && deviation < kCoarsest;
    if (!missed && !wastes) return false;
    fidelity_.learn(asked, measured, deviation, fur_);
    refined_ = missed;
    return true;
}

}  // namespace pelage
