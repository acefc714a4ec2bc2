// flip.h -- the difference that a viewer sees who flips between two pictures.
#pragma once

#include "image.h"

namespace pelage {

// FLIP for pictures on an ordinary display (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom,
// Fairchild, FLIP: A Difference Evaluator for Alternating Images, HPG 2020), on a screen 0.7 m wide
// with 3840 pixels, seen from 0.7 m. [0,1] a pixel, 0 where nothing differs. Light over 1 counts
// as 1, coverage not at all. Both pictures finite, of one size, not empty.
Plane flip(const Image& image, const Image& reference);

}  // namespace pelage
