// mixed_weights.h -- joints and weights of vertices that lie between others.
#pragma once

#include <cstdint>
#include <vector>

#include "rig.h"

namespace pelage {

using Influences = std::vector<Influence>;  // of one vertex

// The same weights with a sum of 1; as they are when they sum to nothing.
Influences normalised(Influences influences);

// Half of each, equal joints joined, the strongest `most` of them, with a sum of 1.
Influences halfway(const Influences& a, const Influences& b, std::size_t most);

}  // namespace pelage
