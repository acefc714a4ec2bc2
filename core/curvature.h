// curvature.h -- how the skin bends around each of its vertices.
#pragma once

#include <span>
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

// At each vertex the best fit to these normals of its one-ring, unit or 0 by vertex; zero where
// that has no two directions.
std::vector<Curvature> curvaturesOf(const Skin& skin, std::span<const vec3> normals);

// The skin's normals, each the mean of those around it by a bell of this standard deviation along
// the skin, m: so many rounds of means over one-rings, at most 64 of them, as spread that far at
// the skin's spacing. Unit, or 0 where they cancel out or the skin has none.
std::vector<vec3> smoothNormals(const Skin& skin, float deviation);

}  // namespace pelage
