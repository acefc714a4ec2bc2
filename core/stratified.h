// stratified.h -- random places that fill a square evenly, however many of them are taken.
#pragma once

#include "types.h"

namespace pelage {

// Place `index` (below 65536) of the sequence of this seed, in [0,1)^2. Of the first 2^k places
// one lies in each cell of every grid of 2^k equal cells with sides of powers of 2; each place by
// itself is uniform, and sequences of different seeds are independent. Sobol's sequence, scrambled
// and shuffled: Burley, "Practical Hash-based Owen Scrambling", JCGT 2020.
vec2 stratified(uint index, uint seed);

}  // namespace pelage
