// ssim.h -- how alike two pictures are in structure.
#pragma once

#include "image.h"

namespace pelage {

// The mean over all pixels of the structural similarity (Wang, Bovik, Sheikh, Simoncelli, Image
// Quality Assessment: From Error Visibility to Structural Similarity, IEEE TIP 2004) of
// display-encoded luminance: windows of 11x11 pixels, Gaussian of sigma 1.5, K1 = 0.01, K2 = 0.03;
// over the edge, the edge's own pixel counts. 1 for equal pictures, at most 1. Light over 1 counts
// as 1, coverage not at all. Both pictures finite, of one size, not empty.
double ssim(const Image& image, const Image& reference);

}  // namespace pelage
