// swatch.h -- a furry ball that shows a coat, as a patch of cloth shows a pattern.
#pragma once

#include "document.h"

namespace pelage {

// A ball of 26 cm with hair of 4.5 cm in the coat's own colors, combed down and back, as dense as
// the same coat is on the built-in animal.
Document swatch(const Fur& fur);

}  // namespace pelage
