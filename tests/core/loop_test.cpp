// loop_test.cpp -- cuts are counted exactly, and points go where Loop says.
#include "core/loop.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/edge_cuts.h"
#include "test_skins.h"

namespace pelage {
namespace {

using glm::dvec3;
using Points = std::vector<dvec3>;

Points once(const Points& points, const std::vector<uvec3>& triangles) {
    const Cuts cuts = cutEdges(points.size(), triangles);
    return loopStep({points}, triangles, cuts.edges).front();
}

void expectNear(dvec3 a, dvec3 b) { EXPECT_LT(glm::distance(a, b), 1e-12) << a.x << ' ' << b.x; }

TEST(EdgeCuts, TrianglesAreCutInFourInOrder) {
    const std::vector<uvec3> one{{0, 1, 2}};
    const Cuts cuts = cutEdges(3, one);
    EXPECT_EQ(cuts.edges, (std::vector<EdgeEnds>{{0, 1}, {1, 2}, {0, 2}}));
    EXPECT_EQ(cuts.triangles, (std::vector<uvec3>{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}));
}

TEST(EdgeCuts, SharedEdgesHaveOneNewVertex) {
    const std::vector<uvec3> two{{0, 1, 2}, {2, 1, 3}};
    EXPECT_EQ(cutEdges(4, two).edges.size(), 5u);
}

// Counting must agree with cutting, whatever the triangles: random ones repeat corners and edges.
TEST(EdgeCuts, SizesAreThoseOfTheCuts) {
    test::Draws draws(7);
    for (int round = 0; round < 40; ++round) {
        std::vector<vec3> positions(4 + draws.below(8), vec3(0.0f));
        std::vector<uvec3> triangles;
        const uint count = static_cast<uint>(positions.size());
        for (uint t = 0; t < 1 + draws.below(20); ++t)
            triangles.emplace_back(draws.below(count), draws.below(count), draws.below(count));
        triangles.push_back(triangles.front());
        const Source source = test::oneMesh(positions, triangles);
        const std::vector<MeshSize> sizes = sizesAfterCuts(source, 3);
        const PartCuts cuts = cutParts(source, 3).front();
        EXPECT_EQ(sizes[0], (MeshSize{count, triangles.size()}));
        std::size_t vertices = count;
        for (std::size_t level = 0; level < 3; ++level) {
            vertices += cuts[level].edges.size();
            EXPECT_EQ(sizes[level + 1], (MeshSize{vertices, cuts[level].triangles.size()}));
        }
    }
}

TEST(Loop, TetrahedronFollowsTheFormula) {
    const Points p{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    const Points out = once(p, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
    ASSERT_EQ(out.size(), 10u);
    const double beta = (5.0 / 8.0 - std::pow(3.0 / 8.0 + std::cos(2 * M_PI / 3) / 4, 2)) / 3;
    expectNear(out[0], (1 - 3 * beta) * p[0] + beta * (p[1] + p[2] + p[3]));
    expectNear(out[4], 3.0 / 8 * (p[0] + p[1]) + 1.0 / 8 * (p[2] + p[3]));
}

TEST(Loop, OpenBordersAreCurvesOfTheirOwn) {
    const Points p{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
    const Points out = once(p, {{0, 1, 2}});
    expectNear(out[0], {1, 1, 0});
    expectNear(out[3], {4, 0, 0});
}

TEST(Loop, PointsOfNoTriangleStay) {
    const Points p{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {5, 6, 7}};
    EXPECT_EQ(once(p, {{0, 1, 2}})[3], dvec3(5, 6, 7));
}

TEST(Loop, ThirdTriangleAtAnEdgeKeepsItsCorners) {
    const Points p{{0, 0, 0}, {8, 0, 0}, {4, 8, 0}, {4, -8, 0}, {4, 0, 8}};
    const Points out = once(p, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    for (const std::size_t v : {0u, 1u, 4u}) EXPECT_EQ(out[v], p[v]);
    EXPECT_NE(out[2], p[2]);
    expectNear(out[5], {4, 0, 0});  // of the edge that three share
}

TEST(Loop, FlippedTriangleKeepsItsCorners) {
    const Points p{{0, 0, 0}, {8, 0, 0}, {4, 8, 0}, {4, -8, 0}};
    const Points out = once(p, {{0, 1, 2}, {0, 1, 3}});
    EXPECT_EQ(out[3], p[3]);
    expectNear(out[4], {4, 0, 0});
}

TEST(Loop, CornerNamedTwiceDoesNoHarm) {
    const Points p{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}};
    const Points plain = once(p, {{0, 1, 2}}), with = once(p, {{0, 1, 2}, {0, 1, 1}, {2, 2, 2}});
    ASSERT_EQ(plain.size(), with.size());
    for (std::size_t v = 0; v < plain.size(); ++v) EXPECT_EQ(plain[v], with[v]);
}

// The subdivider has a table for fewer than fifty neighbours.
TEST(Loop, PoleOfManyNeighboursFollowsTheFormula) {
    constexpr uint kCount = 300;
    Points p{{0, 0, 1}};
    std::vector<uvec3> triangles;
    for (uint i = 0; i < kCount; ++i) {
        p.emplace_back(std::cos(2 * M_PI * i / kCount), std::sin(2 * M_PI * i / kCount), 0.0);
        triangles.emplace_back(0, 1 + i, 1 + (i + 1) % kCount);
    }
    const Points out = once(p, triangles);
    const double alpha = 5.0 / 8.0 - std::pow(3.0 / 8.0 + std::cos(2 * M_PI / kCount) / 4, 2);
    expectNear(out[0], {0, 0, 1 - alpha});
}

TEST(Loop, EveryQuantityFollowsTheSameRule) {
    const Source ball = test::ball(1);
    Points p(ball.positions.begin(), ball.positions.end()), q = p, both = p;
    test::Draws draws(3);
    for (std::size_t v = 0; v < p.size(); ++v) {
        q[v] = draws.inBox(1.0f);
        both[v] = p[v] + q[v];
    }
    const Cuts cuts = cutEdges(p.size(), ball.triangles);
    const auto out = loopStep({p, q, both}, ball.triangles, cuts.edges);
    for (std::size_t v = 0; v < out[0].size(); ++v) expectNear(out[2][v], out[0][v] + out[1][v]);
}

}  // namespace
}  // namespace pelage
