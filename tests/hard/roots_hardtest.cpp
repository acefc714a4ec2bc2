// roots_hardtest.cpp -- numbers, places, ranks and levels of detail of hard counts of hair.
#include <gtest/gtest.h>

#include <cmath>

#include "hair_check.h"
#include "hard_cases.h"

namespace pelage {
namespace {

TEST(HardRoots, EveryCountAndSeed) {
    Document document = test::evenDocument(test::ball(4));  // 5120 faces
    for (const uint hairs : {0u, 1u, 2u, 100u, 5120u, 1u << 20, 5'000'000u})
        for (const uint seed : {0u, 1u, 0xffffffffu})
            for (const float share : {0.0f, 0.3f, 1.0f}) {
                if (hairs > 5120u && (share != 0.3f || seed == 1u)) continue;
                document.fur.hairs = hairs;
                document.fur.seed = seed;
                document.fur.share = share;
                document.fur.over.clump = hairs <= 5120u ? 1.0f : 0.0f;
                const Roots roots = test::rootsOf(document, 1);
                ASSERT_EQ(test::faultOf(*document.skin, roots, hairs), "") << hairs << ", " << seed;
                ASSERT_TRUE(test::sameRoots(roots, test::rootsOf(document, 2))) << hairs;
            }
}

// Expected numbers that are whole: no rounding, whatever the seed.
TEST(HardRoots, WholeExpectationsAreExact) {
    const auto skin = makeSkin(test::sheet(1));  // two faces of half the area each
    for (const uint each : {1u, 3u, 1000u, 999'999u, 1'000'000u})
        for (uint seed = 0; seed < 2; ++seed)
            EXPECT_EQ(scatterRoots(*skin, 2 * each, seed).roots.size(), 2 * each);
}

TEST(HardRoots, AHundredThousandFacesOfLessThanHalfAHair) {
    const auto skin = makeSkin(test::sheet(255));  // 130,050 faces
    for (const uint hairs : {1u, 10'000u, 60'000u})
        EXPECT_EQ(test::faultOf(*skin, scatterRoots(*skin, hairs, 7), hairs), "") << hairs;
}

TEST(HardRoots, EachLevelOfDetailTakesItsShareOfEachCluster) {
    const auto skin = makeSkin(test::ball(4));
    for (const uint hairs : {1u, 300u, 100'000u}) {
        const Roots roots = scatterRoots(*skin, hairs, 3);
        for (const float level : {1.0f, 0.5f, 0.25f, 0.125f, 1e-3f, 0.0f})
            for (const Cluster& cluster : roots.clusters) {
                uint drawn = 0;
                while (drawn < cluster.count && cluster.rank(drawn) < level) ++drawn;
                ASSERT_LE(
                    std::abs(static_cast<float>(drawn) - level * static_cast<float>(cluster.count)),
                    1.0f);
                ASSERT_TRUE(level < 1.0f || drawn == cluster.count);
                ASSERT_TRUE(level > 0.0f || drawn == 0u);
            }
    }
}

TEST(HardRoots, TheCheckSeesEachFault) {
    const auto skin = makeSkin(test::sheet(1));
    const Roots good = scatterRoots(*skin, 1000, 5);
    const auto faultAfter = [&](auto spoil) {
        Roots roots = good;
        spoil(roots);
        return test::faultOf(*skin, roots, 1000);
    };
    EXPECT_EQ(faultAfter([](Roots&) {}), "");
    EXPECT_NE(faultAfter([](Roots& r) { r.roots.pop_back(); }), "");
    EXPECT_NE(faultAfter([](Roots& r) { r.roots[0].triangle ^= 1u; }), "");
    EXPECT_NE(faultAfter([](Roots& r) { r.clusters[0].phase = -1.0f; }), "");
    EXPECT_NE(faultAfter([](Roots& r) { ++r.clusters[0].count; }), "");
    Roots other = good;
    other.roots[3].guide ^= 1u;
    EXPECT_FALSE(test::sameRoots(good, other));
}

}  // namespace
}  // namespace pelage
