// skin_levels_test.cpp -- coarser skins: within their error, without cracks, never gone.
#include "core/skin_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "core/sights.h"
#include "core/test_skins.h"

namespace pelage {
namespace {

uvec3 weldedOf(const Skin& skin, uvec3 t) {
    return {skin.weld[t.x], skin.weld[t.y], skin.weld[t.z]};
}

// By bisection of the triangle, apart from how the levels are made.
float distanceTo(vec3 a, vec3 b, vec3 c, vec3 p) {
    for (int i = 0; i < 16; ++i) {
        const vec3 ab = 0.5f * (a + b), bc = 0.5f * (b + c), ca = 0.5f * (c + a);
        const vec3 quarters[4][3] = {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}};
        const auto* best = &quarters[0];
        float least = INFINITY;
        for (const auto& q : quarters) {
            const float d = glm::distance((q[0] + q[1] + q[2]) / 3.0f, p);
            if (d < least) least = d, best = &q;
        }
        const vec3 x = (*best)[0], y = (*best)[1], z = (*best)[2];
        a = x, b = y, c = z;
    }
    return glm::distance(a, p);
}

TEST(SkinLevels, EveryVertexIsWithinTheErrorOfTheTriangles) {
    const auto skin = makeSkin(test::ball(4));
    for (const int level : {0, 1, 2}) {
        const SkinLevel made = makeSkinLevel(*skin, level);
        for (std::size_t v = 0; v < skin->vertices.size(); v += 7) {
            float least = INFINITY;
            for (const uvec3& triangle : made.triangles) {
                const uvec3 t = weldedOf(*skin, triangle);
                least = std::min(
                    least, distanceTo(skin->vertices[t.x].position, skin->vertices[t.y].position,
                                      skin->vertices[t.z].position, skin->vertices[v].position));
            }
            EXPECT_LE(least, made.error + 1e-3f) << v;
        }
    }
}

TEST(SkinLevels, NoVertexIsShownFartherThanTheReach) {
    const auto skin = makeSkin(test::ball(5));
    for (const int level : {0, 1, 2}) {
        const SkinLevel made = makeSkinLevel(*skin, level);
        ASSERT_EQ(made.triangles.size(), made.patches.order.size());
        for (std::size_t i = 0; i < made.triangles.size(); ++i) {
            const uvec3 coarse = weldedOf(*skin, made.triangles[i]);
            const uvec3 fine = skin->triangles[made.patches.order[i]];
            for (int c = 0; c < 3; ++c)
                EXPECT_LE(glm::distance(skin->vertices[coarse[c]].position,
                                        skin->vertices[fine[c]].position),
                          made.reach);
        }
    }
}

TEST(SkinLevels, ClosedMeshesStayClosed) {
    const auto skin = makeSkin(test::ball(5));
    for (const int level : {0, 1, 2, 3}) {
        std::map<std::pair<uint, uint>, int> balance;
        for (const uvec3& triangle : makeSkinLevel(*skin, level).triangles) {
            const uvec3 t = weldedOf(*skin, triangle);
            for (int c = 0; c < 3; ++c) {
                const uint a = t[c], b = t[(c + 1) % 3];
                balance[std::minmax(a, b)] += a < b ? 1 : -1;
            }
        }
        for (const auto& [edge, sum] : balance) EXPECT_EQ(sum, 0);
    }
}

TEST(SkinLevels, TrianglesBecomeFewerAndNeverVanish) {
    const auto skin = makeSkin(test::ball(6));
    std::size_t before = skin->triangles.size();
    for (const int level : {0, 1, 2}) {
        const std::size_t now = makeSkinLevel(*skin, level).triangles.size();
        EXPECT_LT(now, before);
        before = now;
    }
    EXPECT_LT(before, skin->triangles.size() / 10);
    for (const int level : {6, 10, 16}) EXPECT_GE(makeSkinLevel(*skin, level).triangles.size(), 4u);
}

TEST(SkinLevels, TheSidesOfAThinSheetStayApart) {
    const auto skin = makeSkin(test::twoSheets(40, 0.001f));
    const SkinLevel made = makeSkinLevel(*skin, 1);
    EXPECT_LT(made.triangles.size(), skin->triangles.size() / 4);
    for (const uvec3& triangle : made.triangles) {
        const uvec3 t = weldedOf(*skin, triangle);
        for (int c = 1; c < 3; ++c)
            EXPECT_GT(glm::dot(skin->vertices[t[0]].normal, skin->vertices[t[c]].normal), 0.9f);
    }
}

TEST(SkinLevels, AViewTakesTheCoarsestWithinHalfOfWhatItMayDeviate) {
    const auto skin = makeSkin(test::ball(5));
    const Sight sight = test::sightFrom(vec3(0.0f, 0.0f, 40.0f));
    EXPECT_EQ(levelWithin(*skin, sight, 0.0f), kNoLevel);
    EXPECT_EQ(levelWithin(*skin, test::sightFrom(vec3(0.0f, 0.0f, 0.5f)), 8.0f), kNoLevel);
    const int level = levelWithin(*skin, sight, 2.0f);
    ASSERT_NE(level, kNoLevel);
    const float pixel = 39.0f / sight.pixelsPerMetre;
    EXPECT_LE(makeSkinLevel(*skin, level).error, 1.001f * pixel);
    EXPECT_GT(makeSkinLevel(*skin, level + 1).error, 0.999f * pixel);
}

}  // namespace
}  // namespace pelage
