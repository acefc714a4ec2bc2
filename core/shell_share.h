// shell_share.h -- how much of a coat is better drawn in shells than as strands: as far as they are
// hardly another picture, and cost less.
#pragma once

#include "fidelity.h"

namespace pelage {

// One coat in a view, both ways.
struct CoatInView {
    float apart = 0.0f;          // pixels from one of its hairs to the next
    float flip = 0.0f;           // of shells against strands, the mean over the picture
    double strandSeconds = 0.0;  // of a frame, about
    double shellSeconds = 0.0;
};

// `pelt` is of this coat alone, which has `share` of all hairs, so many on a square metre.
CoatInView coatInView(const Roots& roots, InSight seen, const Sight& sight, const Pelt& pelt,
                      const Detail& detail, const Fineness& otherwise, float share, float perArea,
                      std::size_t vertices);

// [0,1], continuous in all of the view. 0 where every hair is asked for; where errors of strands
// may not reach what shells err (a FLIP, else the distance from hair to hair, in which hairs of
// shells stand elsewhere; without a bound a pixel); and where shells cost more. 1 where they keep
// that twice over and cost half as much.
float shellShare(const Detail& detail, const CoatInView& coat);

}  // namespace pelage
