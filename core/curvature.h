// curvature.h -- how the skin bends around each of its vertices.
#pragma once

#include <vector>

#include "skin.h"

namespace pelage {

// The change of the unit normal for each metre along the skin, 1/m: a symmetric linear map that
// takes the normal to zero. A ball of radius r has 1/r in every direction, a hollow is negative.
struct Curvature {
    float xx = 0.0f, xy = 0.0f, xz = 0.0f, yy = 0.0f;
    float yz = 0.0f, zz = 0.0f, pad0 = 0.0f, pad1 = 0.0f;

    // Of the skin's section along a unit tangent.
    float along(vec3 tangent) const;
};

// At each vertex the best fit to the normals of its one-ring; zero where that has no two
// directions.
std::vector<Curvature> curvaturesOf(const Skin& skin);

}  // namespace pelage
