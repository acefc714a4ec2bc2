// averages_test.cpp -- the promises of averages.h.
#include "core/averages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "canvas.h"

namespace pelage {
namespace {

using test::Canvas;
using test::shuffle;

bool sameBits(const FurVertex& a, const FurVertex& b) {
    return std::memcmp(&a, &b, sizeof(FurVertex)) == 0;
}

uint vertexAt(const Canvas& canvas, vec3 place) {
    std::vector<uint> found;
    canvas.query.within(place, 1e-4f, found);
    EXPECT_EQ(found.size(), 1u);
    return found.empty() ? 0 : found.front();
}

TEST(RingMean, IsThatOfTheNeighbours) {
    Canvas canvas(test::sheet(8));
    shuffle(canvas, 5);
    for (uint v = 0; v < canvas.skin->vertices.size(); ++v) {
        FurVertex sum{};
        for (const uint u : canvas.skin->ring(v)) {
            sum.furLength += canvas.groom.fur[u].furLength;
            sum.density += canvas.groom.fur[u].density;
            sum.direction += canvas.groom.fur[u].direction;
        }
        const float count = static_cast<float>(canvas.skin->ring(v).size());
        const FurVertex mean = ringMean(*canvas.skin, canvas.groom, v);
        EXPECT_NEAR(mean.furLength, sum.furLength / count, 1e-6f);
        EXPECT_NEAR(mean.density, sum.density / count, 1e-6f);
        EXPECT_LT(glm::distance(mean.direction, sum.direction / count), 1e-6f);
    }
}

TEST(RingMean, IsInTheWorld) {
    const Canvas canvas(test::sheet(4, mat4(mat3(3.0f))));
    EXPECT_NEAR(ringMean(*canvas.skin, canvas.groom, 7).furLength,
                3.0f * canvas.groom.fur[7].furLength, 1e-6f);
}

TEST(RingMean, IsTheVertexItselfWhereItHasNoRing) {
    Source source = test::oneMesh({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {5, 5, 5}}, {{0, 2, 1}});
    Canvas canvas(std::move(source));
    shuffle(canvas, 6);
    const uint lone = canvas.skin->weld[3];
    ASSERT_TRUE(canvas.skin->ring(lone).empty());
    EXPECT_TRUE(sameBits(ringMean(*canvas.skin, canvas.groom, lone), canvas.groom.fur[lone]));
}

TEST(Averages, AnEvenFieldHasItsOwnValueAsMeanBitForBit) {
    for (const float reach : {0.01f, 0.3f, 5.0f}) {
        Canvas canvas(test::ball(3));
        for (uint v = 0; v < canvas.groom.fur.size(); ++v)
            canvas.groom.fur.edit(v) = {vec3(0.1f, 0.2f, 0.7f), 0.123f, vec3(1.0f), 0.3f};
        Averages averages(canvas.query, canvas.groom, reach);
        for (uint v = 0; v < canvas.groom.fur.size(); ++v)
            ASSERT_TRUE(sameBits(averages.around(v), canvas.groom.fur[v])) << reach;
    }
}

TEST(Averages, WhereVerticesAreSparseItIsTheMeanOfTheRing) {
    Canvas canvas(test::sheet(10));  // 0.1 m apart
    shuffle(canvas, 7);
    Averages averages(canvas.query, canvas.groom, 0.02f);
    const uint v = vertexAt(canvas, vec3(0.1f, 0.0f, 0.2f));
    const FurVertex around = averages.around(v), ring = ringMean(*canvas.skin, canvas.groom, v);
    const float own = canvas.groom.fur[v].furLength;
    // Only the vertex itself is within the reach; it weighs at most a quarter.
    EXPECT_LE(std::abs(around.furLength - ring.furLength), 0.26f * std::abs(own - ring.furLength));
}

TEST(Averages, WhereManyLieWithinTheReachItIsTheMeanOfTheReach) {
    Canvas canvas(test::sheet(100));  // 0.01 m apart
    for (uint v = 0; v < canvas.groom.fur.size(); ++v) {
        const vec3 place = canvas.skin->vertices[v].position;
        canvas.groom.fur.edit(v).furLength = place.x > 0.035f ? 1.0f : 0.0f;
    }
    Averages averages(canvas.query, canvas.groom, 0.1f);
    const auto lengthAt = [&](float x) {
        return averages.around(vertexAt(canvas, {x, 0.0f, 0.0f})).furLength;
    };
    EXPECT_GT(lengthAt(0.0f), 0.1f);  // four edges from the step
    EXPECT_LT(lengthAt(0.07f), 0.9f);
    EXPECT_EQ(lengthAt(-0.3f), 0.0f);  // far beyond the reach
}

TEST(Averages, TheTwoSidesOfAThinSheetDoNotMix) {
    Canvas canvas(test::twoSheets(40, 0.004f));
    for (uint v = 0; v < canvas.groom.fur.size(); ++v)
        canvas.groom.fur.edit(v).furLength =
            canvas.skin->vertices[v].position.y < 0.0f ? 0.125f : 0.5f;
    Averages averages(canvas.query, canvas.groom, 0.2f);
    for (uint v = 0; v < canvas.groom.fur.size(); ++v)
        ASSERT_EQ(averages.around(v).furLength, canvas.groom.fur[v].furLength);
}

TEST(Averages, AreOfTheGroomAsItWas) {
    Canvas canvas(test::sheet(20));
    Averages averages(canvas.query, canvas.groom, 0.2f);
    const FurVertex before = averages.around(0);
    shuffle(canvas, 9);
    EXPECT_TRUE(sameBits(averages.around(0), before));
}

}  // namespace
}  // namespace pelage
