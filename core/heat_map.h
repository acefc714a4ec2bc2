// heat_map.h -- numbers of [0,1] as colors that get lighter all the way.
#pragma once

#include "image.h"

namespace pelage {

// Linear RGB of a value: black is 0, then purple, red and orange, light yellow is 1. Values outside
// [0,1] count as the nearer end, NaN as 0. After the color map magma (Smith, van der Walt,
// matplotlib 1.5, 2015, CC0): nine of its colors, display-encoded ones between them.
vec3 heatColor(float value);

// The plane in these colors, fully covered.
Image heatMap(const Plane& plane);

}  // namespace pelage
