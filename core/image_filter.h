// image_filter.h -- filters along rows and columns; over the edge, the edge's own pixel counts.
#pragma once

#include <span>

#include "image.h"

namespace pelage {

// Weights of the 2 x radius + 1 pixels around one; they sum to 1. `sigma` in pixels.
std::vector<float> gaussian(double sigma, int radius);

// Each value becomes the sum of its neighbours by `weights`, an odd number of them.
Plane filterRows(const Plane& plane, std::span<const float> weights);
Plane filterColumns(const Plane& plane, std::span<const float> weights);

}  // namespace pelage
