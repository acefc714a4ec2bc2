// edges_test.cpp -- the list of edges of a triangle mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "core/half_edges.h"
#include "tests/core/test_skins.h"

namespace pelage {
namespace {

using Ends = std::pair<uint, uint>;  // smaller vertex first

Ends endsOf(const std::vector<uvec3>& triangles, uint side) {
    const uvec3 t = triangles[side / 3];
    const auto corner = static_cast<int>(side % 3);
    return std::minmax({t[corner], t[(corner + 1) % 3]});
}

TEST(Edges, OfAClosedMeshHaveEachHalfEdgeOnce) {
    const Source ball = test::ball(2);
    const std::vector<MeshEdge> edges = edgesOf(ball.positions.size(), ball.triangles);
    EXPECT_EQ(edges.size(), ball.triangles.size() * 3 / 2);
    std::set<uint> sides;
    for (const MeshEdge edge : edges) {
        EXPECT_TRUE(sides.insert(edge.side).second);
        EXPECT_TRUE(sides.insert(edge.other).second);
        EXPECT_EQ(endsOf(ball.triangles, edge.side), endsOf(ball.triangles, edge.other));
    }
    EXPECT_EQ(sides.size(), 3 * ball.triangles.size());
    EXPECT_LT(*sides.rbegin(), 3 * ball.triangles.size());
}

TEST(Edges, AtABoundaryHaveOneTriangle) {
    const Source sheet = test::sheet(3);
    const std::vector<MeshEdge> edges = edgesOf(sheet.positions.size(), sheet.triangles);
    EXPECT_EQ(edges.size(), 33u);  // 12 along each side of the cells, 9 across them
    EXPECT_EQ(std::ranges::count(edges, MeshEdge::kNone, &MeshEdge::other), 12);
    EXPECT_EQ(std::ranges::count(edges, MeshEdge::kNone, &MeshEdge::side), 0);
    EXPECT_EQ(edgesOf(3, std::vector<uvec3>{{0, 1, 2}}).size(), 3u);
    EXPECT_TRUE(edgesOf(0, {}).empty());
}

// Edge 0 1 has three triangles, edge 1 2 a flipped one, edge 1 4 two that are both outside a
// half-edge mesh, and one triangle names a vertex twice.
TEST(Edges, AreThereOnceHoweverManyTrianglesTheyHave) {
    const std::vector<uvec3> triangles{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 2, 5},
                                       {4, 1, 0}, {2, 2, 6}, {0, 1, 2}};
    const std::vector<MeshEdge> edges = edgesOf(7, triangles);
    std::set<Ends> found;
    for (const MeshEdge edge : edges) {
        EXPECT_TRUE(found.insert(endsOf(triangles, edge.side)).second);
        if (edge.other == MeshEdge::kNone) continue;
        EXPECT_EQ(endsOf(triangles, edge.side), endsOf(triangles, edge.other));
        EXPECT_NE(edge.side, edge.other);
    }
    EXPECT_EQ(found, (std::set<Ends>{
                         {0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {0, 4}, {1, 4}, {2, 5}, {1, 5}}));
}

}  // namespace
}  // namespace pelage
