// nearest_in_triangle.cpp -- by the corner, edge or face whose region holds the point.
#include "nearest_in_triangle.h"

namespace pelage {

TriangleWeights nearestInTriangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    const glm::dvec3 ab = b - a, ac = c - a;
    const double d1 = -glm::dot(ab, a), d2 = -glm::dot(ac, a);
    if (d1 <= 0.0 && d2 <= 0.0) return {0.0, 0.0};
    const double d3 = -glm::dot(ab, b), d4 = -glm::dot(ac, b);
    if (d3 >= 0.0 && d4 <= d3) return {1.0, 0.0};
    const double ofC = d1 * d4 - d3 * d2;
    // An edge needs a length here: where it has none, the others hold its corners.
    if (ofC <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3) return {d1 / (d1 - d3), 0.0};
    const double d5 = -glm::dot(ab, c), d6 = -glm::dot(ac, c);
    if (d6 >= 0.0 && d5 <= d6) return {0.0, 1.0};
    const double ofB = d5 * d2 - d1 * d6;
    if (ofB <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6) return {0.0, d2 / (d2 - d6)};
    const double ofA = d3 * d6 - d5 * d4;
    if (ofA <= 0.0 && d4 >= d3 && d5 >= d6 && d4 - d3 + d5 > d6) {
        const double v = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {1.0 - v, v};
    }
    const double sum = ofA + ofB + ofC;
    // Of corners on a line only what rounding leaves gets here.
    return sum > 0.0 ? TriangleWeights{ofB / sum, ofC / sum} : TriangleWeights{};
}

}  // namespace pelage
