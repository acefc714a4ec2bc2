// photo_regions.h -- the two colors of a fur in its photograph: which pixels are of which.
#pragma once

#include "image.h"

namespace pelage {

// For each pixel 1 where it belongs to the smaller of the two regions that differ most in color,
// else 0; all 0 where there is one color only. Colors are compared where single hairs no longer
// count, over a 64th of the longer side and at least 4 pixels, by hue and lightness: the stripes of
// a zebra have no hue. Two means in Oklab (Ottosson, "A perceptual color space for image
// processing", 2020), always the same ones for a picture. Transparent pixels are 0.
std::vector<unsigned char> colorRegions(const Image& photo);

}  // namespace pelage
