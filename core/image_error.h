// image_error.h -- how far a picture is from its reference, by every figure that tells of fur.
//
// RMSE and FLIP rank noise and bias differently and SSIM is a second opinion, so that they belong
// together. Both pictures need the same size, at least one pixel and finite numbers.
#pragma once

#include <optional>

#include "image.h"

namespace pelage {

// Of the coverage alone. A pixel belongs to the band of the silhouette when the reference covers it
// in part: by more than half a step of 16 bits away from 0 and 1.
struct CoverageErrors {
    std::size_t bandPixels;
    double bandBias;    // mean of coverage - reference over the band; 0 without a band
    double bandRmse;    // root of the mean of its square; 0 without a band
    double areaRatio;   // covered area / that of the reference; 1 when both are 0
    double silhouette;  // share of the area covered by either that is not covered by both, [0,1]
};

struct ImageErrors {
    double rmse;           // of linear RGB, over all pixels and channels
    double luminanceBias;  // mean luminance / that of the reference - 1; 0 when both are black
    double flipMean;       // core/flip.h
    double flip99;         // 99 % of the pixels have at most this
    double ssim;           // core/ssim.h
    std::optional<CoverageErrors> coverage;  // where one of both has a pixel not fully covered
    Plane flipMap;
};

// A ratio to a reference that is 0 is infinite. Coverage outside [0,1] counts as the nearer end.
// Throws std::runtime_error: "96x64 pixels, the reference has 64x64", "the reference has no
// pixels", "pixel 3, 4 of the picture is not finite" (x from the left, y from the top, from 0).
ImageErrors imageErrors(const Image& image, const Image& reference);

}  // namespace pelage
