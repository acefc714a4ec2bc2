// fidelity.h -- how coarse a picture may be for the FLIP that is asked for: a guess from the view,
// set right by pictures that were measured.
//
// The error is the mean of FLIP (flip.h) over the whole picture, against the picture of all hairs
// with as many samples.
#pragma once

#include "lod.h"

namespace pelage {

// What fur there is in a picture, about.
struct FurInView {
    float share = 0.0f;   // of the picture that it covers, [0,1]
    float pixels = 0.0f;  // width of its widest hairs, a mean over it
};
FurInView furInView(const Roots& roots, const InSight& seen, const Sight& sight, const Pelt& pelt);

// Pixels, however great the error that is asked for. The mean over a picture counts its background
// too: where the fur is small in it, hair that is a tuft to the eye costs next to no error.
constexpr float kCoarsest = 1.0f;

// Below it every hair is drawn.
constexpr float kFinest = 0.01f;

class Fidelity {
public:
    // The error of a picture with edges off by `deviation` pixels.
    float flipAt(float deviation, const FurInView& fur) const;
    // The greatest deviation that keeps the error, with a little to spare: [kFinest, kCoarsest] or
    // 0.
    float deviationWithin(float flip, const FurInView& fur) const;
    // From the error that such a picture turned out to have. Pictures that miss what is `asked` and
    // are made anew with what was learnt get finer and finer, until they keep it.
    void learn(float asked, float measured, float deviation, const FurInView& fur);

private:
    float factor_ = 1.0f;  // by which errors are greater than guessed
};

}  // namespace pelage
