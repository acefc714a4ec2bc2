// clumps.h -- which hair gathers to which: the guides of clumps.
#pragma once

#include "scatter.h"

namespace pelage {

// Sets Root::guide of every root. Of each coat that clumps, one hair in clumpSize is a guide
// (random rounding in each cluster, its first ones in the order of rank, so that guides are spread
// evenly and stay when hairs are thinned). A hair gathers to the nearest guide of its coat among
// those whose skin faces its way, so that clumps do not reach through an ear; without one nearby,
// and where its coat does not clump, it is its own. The same on every machine and for any number of
// threads.
void assignGuides(Roots& roots, const Skin& skin, const Fur& fur);

// True where assignGuides may give other guides for the two furs of one set of roots.
bool guidesDiffer(const Fur& a, const Fur& b);

}  // namespace pelage
