// nearest_in_triangle.h -- the point of a triangle that is nearest to another point.
#pragma once

#include "types.h"

namespace pelage {

struct TriangleWeights {
    double u = 0.0, v = 0.0;  // of the second and third corner, each >= 0, sum <= 1
};

// Of the point of a triangle nearest to the origin (after Ericson, Real-Time Collision Detection,
// 2005, section 5.1.5). Where the corners lie on a line it is a point of the triangle all the same,
// though by rounding maybe not the nearest.
TriangleWeights nearestInTriangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c);

}  // namespace pelage
