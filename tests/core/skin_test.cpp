// skin_test.cpp -- the promises of core/skin.h and core/half_edges.h.
#include "core/skin.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "core/half_edges.h"
#include "core/test_skins.h"

namespace pelage {
namespace {

using test::oneMesh;

TEST(Skin, WeldsByExactPositionWithinAMesh) {
    // Two triangles that share an edge but no vertex number, one corner as -0.
    Source source = oneMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, -0.0f}, {1, 1, 0}, {0, 1, 0}},
                            {{0, 1, 2}, {3, 4, 5}});
    const auto skin = makeSkin(std::move(source));
    EXPECT_EQ(skin->report.weldedVertices, 4u);
    EXPECT_EQ(skin->weld[1], skin->weld[3]);
    EXPECT_EQ(skin->weld[2], skin->weld[5]);
    EXPECT_EQ(skin->report.boundaryEdges, 4u);
}

TEST(Skin, DoesNotWeldAcrossMeshes) {
    Source source = oneMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                            {{0, 1, 2}, {3, 4, 5}});
    source.parts[0].vertexCount = 3;
    source.parts[0].triangleCount = 1;
    SourcePart other = source.parts[0];
    other.mesh = 1;
    other.firstVertex = 3;
    other.firstTriangle = 1;
    source.parts.push_back(other);
    EXPECT_EQ(makeSkin(std::move(source))->report.weldedVertices, 6u);
}

TEST(Skin, KeepsEveryTriangleInTheOrderOfTheFile) {
    const Source source = test::sheet(7);
    const std::vector<uvec3> triangles = source.triangles;
    const std::vector<vec3> positions = source.positions;
    const auto skin = makeSkin(test::sheet(7));
    ASSERT_EQ(skin->triangles.size(), triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(skin->vertices[skin->triangles[t][c]].position, positions[triangles[t][c]]);
}

TEST(Skin, NeighboursInSpaceAreNeighboursInMemory) {
    const auto skin = makeSkin(test::sheet(128));
    double sum = 0.0;
    for (std::size_t v = 1; v < skin->vertices.size(); ++v)
        sum += glm::distance(skin->vertices[v].position, skin->vertices[v - 1].position);
    // In the order of the rows the mean step is about 1 cell too, but rows jump by the sheet's
    // width; what counts is that a run of 256 vertices stays together.
    double widest = 0.0;
    for (std::size_t first = 0; first + 256 <= skin->vertices.size(); first += 256) {
        vec3 lower(1e9f), upper(-1e9f);
        for (std::size_t v = first; v < first + 256; ++v) {
            lower = glm::min(lower, skin->vertices[v].position);
            upper = glm::max(upper, skin->vertices[v].position);
        }
        widest +=
            glm::distance(lower, upper) / (static_cast<double>(skin->vertices.size()) / 256.0);
    }
    EXPECT_LT(sum / static_cast<double>(skin->vertices.size()), 3.0 / 128.0);
    EXPECT_LT(widest, 0.35) << "mean extent of a run of 256 vertices of a sheet of side 1";
}

TEST(Skin, CountsNonManifoldFlippedAndDegenerateAndDropsNone) {
    // Three triangles at one edge, one flipped neighbour, one of no area, one with a corner twice.
    Source source =
        oneMesh({{0, 0, 0},
                 {1, 0, 0},
                 {0, 1, 0},
                 {0, -1, 0},
                 {0, 0, 1},
                 {5, 0, 0},
                 {6, 0, 0},
                 {5, 1, 0},
                 {6, 1, 0},
                 {7, 0, 0}},
                {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {5, 6, 7}, {6, 7, 8}, {5, 6, 9}, {5, 5, 6}});
    const auto skin = makeSkin(std::move(source));
    EXPECT_EQ(skin->triangles.size(), 7u);
    EXPECT_EQ(skin->report.nonManifoldEdges, 1u);
    EXPECT_EQ(skin->report.degenerateFaces, 2u);
    EXPECT_GE(skin->report.flippedEdges, 1u);
}

TEST(Topology, ADoubledTriangleMakesItsEdgesFlippedNotManifold) {
    const Topology topology = makeTopology(3, std::vector<uvec3>{{0, 1, 2}, {0, 1, 2}});
    EXPECT_EQ(topology.flippedEdges, 3u);
    EXPECT_EQ(topology.boundaryEdges, 0u);
    EXPECT_EQ(topology.nonManifoldEdges, 0u);
}

TEST(Topology, RingsHoldEveryNeighbourOnceAlsoAcrossNonManifoldEdges) {
    const std::vector<uvec3> triangles{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {2, 1, 5}, {2, 2, 6}};
    const Topology topology = makeTopology(7, triangles);
    std::vector<std::set<uint>> expected(7);
    for (const uvec3 t : triangles)
        for (int c = 0; c < 3; ++c) {
            const uint a = t[c], b = t[(c + 1) % 3];
            if (a == b) continue;
            expected[a].insert(b);
            expected[b].insert(a);
        }
    for (uint v = 0; v < 7; ++v) {
        const std::vector<uint> ring(topology.rings.begin() + topology.ringFirst[v],
                                     topology.rings.begin() + topology.ringFirst[v + 1]);
        EXPECT_EQ(ring.size(), expected[v].size()) << "vertex " << v;
        EXPECT_EQ(std::set<uint>(ring.begin(), ring.end()), expected[v]) << "vertex " << v;
    }
}

TEST(Skin, NormalsPointOutAlsoWhereAMatrixMirrors) {
    for (const float side : {1.0f, -1.0f}) {
        const mat4 matrix = glm::scale(mat4(1.0f), vec3(side, 2.0f, 1.0f));
        const auto skin = makeSkin(test::sheet(4, matrix));
        for (const SkinVertex& v : skin->vertices)
            EXPECT_NEAR(v.normal.y, 1.0f, 1e-6f) << "x scaled by " << side;
    }
}

TEST(Skin, PaintedValuesReturnFromTheWorldAsTheyWere) {
    mat4 matrix = glm::rotate(mat4(1.0f), 0.7f, glm::normalize(vec3(1, 2, 3)));
    matrix = glm::scale(matrix, vec3(100.0f, 50.0f, -20.0f));
    const auto skin = makeSkin(test::sheet(2, matrix));
    FurVertex fur{};
    fur.direction = vec3(0.3f, -0.4f, 0.5f);
    fur.furLength = 0.02f;
    fur.density = 0.75f;
    const FurVertex world = furToWorld(*skin, 0, fur);
    EXPECT_NEAR(world.furLength, 0.02f * std::cbrt(100.0f * 50.0f * 20.0f), 1e-5f);
    const FurVertex back = furToMesh(*skin, 0, world);
    EXPECT_NEAR(glm::distance(back.direction, fur.direction), 0.0f, 1e-5f);
    EXPECT_NEAR(back.furLength, fur.furLength, 1e-7f);
}

TEST(Skin, AnIdentityMatrixKeepsPaintedValuesBitForBit) {
    const auto skin = makeSkin(test::sheet(2));
    FurVertex fur{};
    fur.direction = vec3(0.1f, 0.2f, 0.3f);
    fur.furLength = 0.0123f;
    EXPECT_TRUE(furToMesh(*skin, 0, furToWorld(*skin, 0, fur)) == fur);
}

TEST(Skin, AFlattenedNodeKeepsItsFieldsFinite) {
    const auto skin = makeSkin(test::sheet(2, glm::scale(mat4(1.0f), vec3(1, 1, 0))));
    FurVertex fur{};
    fur.direction = vec3(0, 0, 1);
    fur.furLength = 1.0f;
    const FurVertex back = furToMesh(*skin, 0, furToWorld(*skin, 0, fur));
    EXPECT_TRUE(std::isfinite(glm::length(back.direction)) && std::isfinite(back.furLength));
}

TEST(Skin, UnusedVerticesAreKeptCountedAndOutsideTheBounds) {
    Source source = oneMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {50, 50, 50}}, {{0, 1, 2}});
    const auto skin = makeSkin(std::move(source));
    EXPECT_EQ(skin->vertices.size(), 4u);
    EXPECT_EQ(skin->report.unusedVertices, 1u);
    EXPECT_EQ(skin->upper, vec3(1, 1, 0));
}

TEST(Skin, AnEmptyOrPointLikeSkinHasSizeOne) {
    EXPECT_EQ(makeSkin(Source{})->size(), 1.0f);
    EXPECT_EQ(makeSkin(oneMesh({{2, 2, 2}}, {{0, 0, 0}}))->size(), 1.0f);
}

}  // namespace
}  // namespace pelage
