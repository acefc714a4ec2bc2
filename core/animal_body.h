// animal_body.h -- the pieces that the built-in animal is made of. Private to animal*.cpp.
#pragma once

#include <vector>

#include "animal_shape.h"

namespace pelage::animal {

// In the order in which they are joined. Pieces thinner than `cell` (m) come out thicker.
std::vector<Part> bodyParts(float cell);

}  // namespace pelage::animal
