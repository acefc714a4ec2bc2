// nearest_in_triangle_test.cpp -- the nearest point of a triangle against points all over it.
#include <gtest/gtest.h>

#include "core/nearest_in_triangle.h"
#include "core/strand.h"

namespace pelage {
namespace {

using glm::dvec3;

dvec3 pointOf(dvec3 a, dvec3 b, dvec3 c, double u, double v) {
    return a + u * (b - a) + v * (c - a);
}

bool isWithin(TriangleWeights w) { return w.u >= 0.0 && w.v >= 0.0 && w.u + w.v <= 1.0 + 1e-12; }

// No point of a fine grid over the triangle is nearer to the origin.
void expectNearest(dvec3 a, dvec3 b, dvec3 c) {
    const auto [u, v] = nearestInTriangle(a, b, c);
    ASSERT_TRUE(isWithin({u, v}));
    const double found = glm::length(pointOf(a, b, c, u, v));
    constexpr int kSteps = 40;
    for (int i = 0; i <= kSteps; ++i)
        for (int j = 0; i + j <= kSteps; ++j) {
            const dvec3 other = pointOf(a, b, c, i / double{kSteps}, j / double{kSteps});
            ASSERT_LE(found, glm::length(other) + 1e-9);
        }
}

dvec3 corner(uint id) { return dvec3(randomInBall(id)) + dvec3(randomInBall(id + 7000u)); }

TEST(NearestInTriangle, NoOtherPointOfTheTriangleIsNearer) {
    for (uint i = 0; i < 300; ++i)
        expectNearest(corner(48u * i), corner(48u * i + 16u), corner(48u * i + 32u));
}

TEST(NearestInTriangle, IsAPointOfTheTriangleWhereCornersLieOnALine) {
    for (uint i = 0; i < 300; ++i) {
        const dvec3 a = corner(32u * i), way = corner(32u * i + 16u);
        for (const double b : {-1.5, 0.0, 0.5})
            for (const double c : {-1.5, 0.0, 2.0})
                EXPECT_TRUE(isWithin(nearestInTriangle(a, a + b * way, a + c * way)));
    }
}

}  // namespace
}  // namespace pelage
