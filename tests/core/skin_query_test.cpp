// skin_query_test.cpp -- rays and radius queries against the slow, obvious answer.
#include "core/skin_query.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test_skins.h"

namespace pelage {
namespace {

using test::Draws;

std::vector<uint> slowWithin(const Skin& skin, vec3 point, float radius) {
    std::vector<bool> used(skin.vertices.size(), false);
    for (const uvec3 t : skin.triangles) used[t.x] = used[t.y] = used[t.z] = true;
    std::vector<uint> found;
    for (uint v = 0; v < skin.vertices.size(); ++v) {
        const vec3 away = skin.vertices[v].position - point;
        if (used[v] && glm::dot(away, away) <= radius * radius) found.push_back(v);
    }
    return found;
}

TEST(SkinQuery, FindsEveryVertexWithinTheRadiusInRisingOrder) {
    const auto skin = makeSkin(test::ball(4));
    const SkinQuery query(skin);
    Draws draws(1);
    for (int i = 0; i < 300; ++i) {
        const vec3 point = draws.inBox(1.2f);
        const float radius = draws.in(0.0f, i % 10 == 0 ? 3.0f : 0.4f);
        std::vector<uint> found;
        query.within(point, radius, found);
        EXPECT_EQ(found, slowWithin(*skin, point, radius)) << "query " << i;
    }
}

TEST(SkinQuery, AppendsToWhatWasFound) {
    const SkinQuery query(makeSkin(test::sheet(4)));
    std::vector<uint> found{7};
    query.within(vec3(0.0f), 10.0f, found);
    EXPECT_EQ(found.size(), 26u);
    EXPECT_EQ(found[0], 7u);
}

TEST(SkinQuery, FindsAVertexAtRadiusZeroAndAllAtEndlessRadius) {
    const auto skin = makeSkin(test::ball(3));
    const SkinQuery query(skin);
    std::vector<uint> found;
    query.within(skin->vertices[5].position, 0.0f, found);
    EXPECT_EQ(found, std::vector<uint>{5});
    found.clear();
    query.within(vec3(0.0f), INFINITY, found);
    EXPECT_EQ(found.size(), skin->vertices.size());
}

TEST(SkinQuery, UnusedVerticesDoNotCount) {
    Source source = test::sheet(2);
    source.positions.insert(source.positions.begin(), vec3(0.01f, 0.0f, 0.0f));
    for (uvec3& t : source.triangles) t += uvec3(1);
    source.parts[0].vertexCount += 1;
    const auto skin = makeSkin(std::move(source));
    const SkinQuery query(skin);
    std::vector<uint> found;
    query.within(vec3(0.0f), 10.0f, found);
    EXPECT_EQ(found.size(), 9u);
}

TEST(SkinQuery, RayMeetsTheSkinFromEitherSide) {
    const SkinQuery query(makeSkin(test::sheet(7)));
    const auto above = query.cast({0.11f, 2.0f, 0.07f}, {0.0f, -3.0f, 0.0f});
    ASSERT_TRUE(above);
    EXPECT_NEAR(above->distance, 2.0f, 1e-5f);
    EXPECT_NEAR(glm::distance(above->position, {0.11f, 0.0f, 0.07f}), 0.0f, 1e-6f);
    EXPECT_EQ(above->normal, vec3(0.0f, 1.0f, 0.0f));
    const auto below = query.cast({0.11f, -2.0f, 0.07f}, {0.0f, 1.0f, 0.0f});
    ASSERT_TRUE(below);
    EXPECT_EQ(below->normal, vec3(0.0f, -1.0f, 0.0f));
    EXPECT_EQ(below->triangle, above->triangle);
}

TEST(SkinQuery, BarycentricWeightsNameTheHitPoint) {
    const auto skin = makeSkin(test::ball(2));
    const SkinQuery query(skin);
    Draws draws(2);
    for (int i = 0; i < 200; ++i) {
        const vec3 from = 3.0f * glm::normalize(draws.inBox(1.0f) + vec3(0.0f, 1e-4f, 0.0f));
        const auto hit = query.cast(from, 0.2f * draws.inBox(1.0f) - from);
        if (!hit) continue;
        const uvec3 t = skin->triangles[hit->triangle];
        const vec3 there = (1.0f - hit->u - hit->v) * skin->vertices[t.x].position +
                           hit->u * skin->vertices[t.y].position +
                           hit->v * skin->vertices[t.z].position;
        EXPECT_LT(glm::distance(there, hit->position), 1e-6f);
        EXPECT_NEAR(glm::distance(from, hit->position), hit->distance, 1e-5f);
        EXPECT_NEAR(glm::length(hit->normal), 1.0f, 1e-5f);
    }
}

TEST(SkinQuery, RaysDoNotSlipThroughEdges) {
    const auto skin = makeSkin(test::ball(3));
    const SkinQuery query(skin);
    for (const SkinVertex& vertex : skin->vertices)
        EXPECT_TRUE(query.cast(vec3(0.0f), vertex.position));
}

TEST(SkinQuery, DegenerateTrianglesAreNeverMet) {
    // A sliver without area in front of a real triangle, and a triangle with a corner twice.
    const auto skin = makeSkin(
        test::oneMesh({{-1, 1, 0}, {0, 1, 0}, {1, 1, 0}, {-1, 0, -1}, {0, 0, 1}, {1, 0, -1}},
                      {{0, 1, 2}, {0, 1, 1}, {3, 4, 5}}));
    const SkinQuery query(skin);
    for (const float x : {-0.5f, 0.0f, 0.25f}) {
        const auto hit = query.cast({x, 2.0f, 0.0f}, {0.0f, -1.0f, 0.0f});
        EXPECT_TRUE(!hit || hit->triangle == 2u);
    }
    const SkinQuery none(makeSkin(test::oneMesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}})));
    EXPECT_FALSE(none.cast({0.5f, 1.0f, 0.0f}, {0.0f, -1.0f, 0.0f}));
}

// The distance from a point to the skin, by trying every triangle at many places.
float slowDistance(const Skin& skin, vec3 point) {
    constexpr int kParts = 40;
    float least = INFINITY;
    for (const uvec3 t : skin.triangles)
        for (int i = 0; i <= kParts; ++i)
            for (int k = 0; i + k <= kParts; ++k) {
                const float u = static_cast<float>(i) / kParts, v = static_cast<float>(k) / kParts;
                const vec3 there = (1.0f - u - v) * skin.vertices[t.x].position +
                                   u * skin.vertices[t.y].position +
                                   v * skin.vertices[t.z].position;
                least = std::min(least, glm::distance(point, there));
            }
    return least;
}

TEST(SkinQuery, NearestIsTheNearestPointOfTheSkinWithItsNormal) {
    const auto skin = makeSkin(test::ball(1));
    const SkinQuery query(skin);
    Draws draws(3);
    for (int i = 0; i < 100; ++i) {
        const vec3 point = draws.inBox(1.5f);
        const auto hit = query.nearest(point);
        ASSERT_TRUE(hit);
        const float slow = slowDistance(*skin, point);
        EXPECT_LE(hit->distance, slow + 1e-6f);
        EXPECT_GE(hit->distance, slow - 0.02f);
        EXPECT_NEAR(glm::distance(point, hit->position), hit->distance, 1e-6f);
        const uvec3 t = skin->triangles[hit->triangle];
        const vec3 there = (1.0f - hit->u - hit->v) * skin->vertices[t.x].position +
                           hit->u * skin->vertices[t.y].position +
                           hit->v * skin->vertices[t.z].position;
        EXPECT_LT(glm::distance(there, hit->position), 1e-6f);
        EXPECT_NEAR(glm::length(hit->normal), 1.0f, 1e-6f);
        EXPECT_GT(glm::dot(hit->normal, there), 0.0f);  // outside, also for a point inside
    }
}

TEST(SkinQuery, NearestOfAVertexAndOfAPointOfAFaceIsItself) {
    const auto skin = makeSkin(test::ball(3));
    const SkinQuery query(skin);
    for (const SkinVertex& vertex : skin->vertices)
        EXPECT_LT(glm::distance(query.nearest(vertex.position)->position, vertex.position), 1e-7f);
    for (const uvec3 t : skin->triangles) {
        const vec3 middle = (skin->vertices[t.x].position + skin->vertices[t.y].position +
                             skin->vertices[t.z].position) /
                            3.0f;
        EXPECT_EQ(skin->triangles[query.nearest(middle)->triangle], t);
    }
}

TEST(SkinQuery, NearestThatFacesAWayFindsThatSideOfAThinSheet) {
    const SkinQuery query(makeSkin(test::twoSheets(10, 0.004f)));
    for (const float y : {-0.01f, -0.001f, 0.001f, 0.01f}) {
        const vec3 point(0.13f, y, 0.07f);
        EXPECT_GT(query.nearest(point, {0, 1, 0})->position.y, 0.0f);
        EXPECT_LT(query.nearest(point, {0, -1, 0})->position.y, 0.0f);
        EXPECT_EQ(query.nearest(point)->position.y > 0.0f, y > 0.0f);
    }
    EXPECT_FALSE(query.nearest(vec3(0.0f), {1, 0, 0}));
}

TEST(SkinQuery, OfEquallyNearTrianglesTheFirstIsNearest) {
    const auto skin = makeSkin(
        test::oneMesh({{-1, 0, -1}, {0, 0, 1}, {1, 0, -1}}, {{0, 1, 2}, {0, 2, 1}, {0, 1, 2}}));
    const SkinQuery query(skin);
    for (const float height : {-1.0f, 0.0f, 2.0f})
        EXPECT_EQ(query.nearest({0.1f, height, 0.0f})->triangle, 0u);
}

TEST(SkinQuery, DegenerateTrianglesAreNeverNearest) {
    const SkinQuery query(makeSkin(
        test::oneMesh({{-1, 1, 0}, {0, 1, 0}, {1, 1, 0}, {-1, 0, -1}, {0, 0, 1}, {1, 0, -1}},
                      {{0, 1, 2}, {0, 1, 1}, {3, 4, 5}})));
    for (const vec3 point : {vec3(0, 2, 0), vec3(0.1f, 1, 0), vec3(5, 5, 5)})
        EXPECT_EQ(query.nearest(point)->triangle, 2u);
    const SkinQuery none(makeSkin(test::oneMesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}})));
    EXPECT_FALSE(none.nearest({0.5f, 1.0f, 0.0f}));
}

TEST(SkinQuery, NearestWorksFarFromTheOriginAndFarFromTheSkin) {
    const mat4 moved = [] {
        mat4 matrix(1.0f);
        matrix[3] = {1e4f, -2e4f, 5e3f, 1.0f};
        return matrix;
    }();
    const SkinQuery query(makeSkin(test::sheet(8, moved)));
    const auto above = query.nearest({1e4f + 0.25f, -2e4f + 100.0f, 5e3f});
    ASSERT_TRUE(above);
    EXPECT_NEAR(above->distance, 100.0f, 1e-3f);
    EXPECT_LT(glm::distance(above->position, {1e4f + 0.25f, -2e4f, 5e3f}), 1e-2f);
    const auto origin = query.nearest(vec3(0.0f));
    ASSERT_TRUE(origin);
    EXPECT_LT(glm::distance(origin->position, {1e4f - 0.5f, -2e4f, 5e3f - 0.5f}), 1e-2f);
}

TEST(SkinQuery, FanHoldsTheTrianglesOfAVertexOneBesideTheOther) {
    const auto skin = makeSkin(test::ball(2));
    const SkinQuery query(skin);
    std::size_t count = 0;
    for (uint v = 0; v < skin->vertices.size(); ++v) {
        const auto fan = query.fan(v);
        for (std::size_t i = 0; i < fan.size(); ++i) {
            const bool there =
                std::any_of(skin->triangles.begin(), skin->triangles.end(), [&](uvec3 t) {
                    return t == uvec3(v, fan[i]) || t == uvec3(fan[i].y, v, fan[i].x) ||
                           t == uvec3(fan[i], v);
                });
            EXPECT_TRUE(there);
            EXPECT_EQ(fan[i].x, fan[(i + fan.size() - 1) % fan.size()].y);
        }
        count += fan.size();
    }
    EXPECT_EQ(count, 3 * skin->triangles.size());
}

TEST(SkinQuery, EmptySkinAndNonsenseRaysHitNothing) {
    const SkinQuery empty(makeSkin(test::oneMesh({}, {})));
    std::vector<uint> found;
    empty.within(vec3(0.0f), 1.0f, found);
    EXPECT_TRUE(found.empty());
    EXPECT_FALSE(empty.cast(vec3(0.0f), vec3(0.0f, 0.0f, 1.0f)));
    EXPECT_FALSE(empty.nearest(vec3(0.0f)));
    const SkinQuery query(makeSkin(test::sheet(2)));
    EXPECT_FALSE(query.cast({0.0f, 1.0f, 0.0f}, vec3(0.0f)));
    EXPECT_FALSE(query.cast({0.0f, 1.0f, 0.0f}, vec3(NAN)));
    EXPECT_FALSE(query.nearest(vec3(0.0f, NAN, 0.0f)));
    EXPECT_FALSE(query.nearest(vec3(INFINITY)));
    query.within(vec3(0.0f), NAN, found);
    EXPECT_TRUE(found.empty());
}

TEST(SkinQuery, CanBeMoved) {
    SkinQuery first(makeSkin(test::sheet(2)));
    SkinQuery second = std::move(first);
    EXPECT_TRUE(second.cast({0.1f, 1.0f, 0.1f}, {0.0f, -1.0f, 0.0f}));
}

}  // namespace
}  // namespace pelage
