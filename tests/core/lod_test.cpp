// lod_test.cpp -- how much of the hair is chosen: the rules, their bounds, and no jumps.
#include "core/lod.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/sights.h"
#include "core/strand.h"
#include "core/test_skins.h"
#include "tests/figures.h"

namespace pelage {
namespace {

using test::choiceOf, test::kNoSkin, test::kRoots, test::oneCluster, test::plainPelt, test::seenOf,
    test::sightFrom;
using Rule = Detail::Rule;

constexpr Detail kAll{.rule = Rule::all};

Detail pixels(float limit) { return {.rule = Rule::pixels, .limit = limit}; }
Detail share(float limit) { return {.rule = Rule::share, .limit = limit}; }

// m; where hairs of plainPelt are one pixel wide.
float pixelDistance() { return plainPelt().widest * sightFrom(vec3(0, 0, 1)).pixelsPerMetre; }

std::size_t hairsAt(float distance, const Detail& detail) {
    return choiceOf(oneCluster(), sightFrom(vec3(0, 0, distance)), detail).hairs;
}

TEST(Lod, AllHairsAreKeptWhereTheyAreWiderThanAPixel) {
    for (const float closer : {0.1f, 0.5f, 0.99f})
        EXPECT_EQ(hairsAt(closer * pixelDistance(), Detail{}), kRoots) << closer;
}

TEST(Lod, CountsFallAsOneOverDistance) {
    const double atTwo = static_cast<double>(hairsAt(2.0f * pixelDistance(), Detail{}));
    EXPECT_LT(atTwo, kRoots);
    for (const float farther : {3.0f, 4.0f, 8.0f, 16.0f, 32.0f}) {
        const double hairs = static_cast<double>(hairsAt(farther * pixelDistance(), Detail{}));
        EXPECT_NEAR(hairs * static_cast<double>(farther) / (2.0 * atTwo), 1.0, 1e-3) << farther;
    }
    EXPECT_EQ(hairsAt(4.0f * pixelDistance(), kAll), kRoots);
}

TEST(Lod, TheDistanceAlongTheViewCountsAndNotTheAngle) {
    const Sight sight = sightFrom(vec3(0, 0, 4.0f * pixelDistance()));
    const Roots beside = oneCluster(vec3(0.3f, 0.2f, 0.0f));
    EXPECT_EQ(choiceOf(beside, sight, Detail{}).hairs, hairsAt(4.0f * pixelDistance(), Detail{}));
}

TEST(Lod, AShareIsAShareAtAnyDistance) {
    const double tenth = static_cast<double>(hairsAt(1.0f, share(0.1f)));
    for (const float part : {0.2f, 0.4f, 0.8f})
        for (const float distance : {1.0f, 50.0f})
            EXPECT_NEAR(static_cast<double>(hairsAt(distance, share(part))) / tenth,
                        10.0 * static_cast<double>(part), 1e-2);
    EXPECT_EQ(hairsAt(1.0f, share(1.0f)), kRoots);
}

TEST(Lod, NoEdgeIsOffByMoreThanThePixelsAllowed) {
    for (const float limit : {0.01f, 0.1f, 0.5f, 2.0f})
        for (const float width : {1e-4f, 0.01f, 0.5f, 3.0f, 40.0f}) {  // pixels
            const float lod = shareKept(pixels(limit), 0.5f * width, width, 0.0f);
            EXPECT_NEAR(0.5f * (width / lod - width), limit, 1e-3f * limit + 1e-5f * width);
        }
    // As much as the paper's rule far away, where it allows half a pixel on each side.
    EXPECT_NEAR(shareKept(pixels(0.5f), 1e-3f, 1e-3f, 0.0f), 1e-3f, 1e-5f);
}

TEST(Lod, ADeviationMakesAnyRuleCoarserAndNoneFiner) {
    for (const Detail& detail : {kAll, Detail{}, share(0.3f), pixels(0.5f)}) {
        float last = 2.0f;
        for (const float deviation : {0.0f, 0.01f, 0.5f, 1.0f, 8.0f}) {
            const float lod = shareKept(detail, 0.7f, 0.9f, deviation);
            EXPECT_LE(lod, last);
            EXPECT_GT(lod, 0.0f);
            last = lod;
        }
        EXPECT_FLOAT_EQ(last, 0.9f / 16.9f);
    }
}

TEST(Lod, ASmallStepOfTheCameraChangesLittle) {
    constexpr float kStep = 1.001f;
    for (const Detail& detail : {Detail{}, share(0.3f), pixels(0.1f), pixels(1.0f)}) {
        float last = 0.0f;
        for (float distance = 0.1f; distance < 100.0f; distance *= kStep) {
            const Choice choice = choiceOf(oneCluster(), sightFrom(vec3(0, 0, distance)), detail);
            ASSERT_EQ(choice.clusters.size(), 1u);
            const float lod = choice.clusters[0].lod;
            if (last > 0.0f) {
                EXPECT_NEAR(lod / last, 1.0f, 1.5f * (kStep - 1.0f)) << distance;
            }
            last = lod;
        }
    }
}

// Level of detail and the rank at which hairs have faded out, as they are chosen.
Choice::Drawn levelOf(float lod) {
    return choiceOf(oneCluster(), sightFrom(vec3(0, 0, 1)), share(lod)).clusters.at(0);
}

TEST(Lod, ThinningKeepsTheSumOfTheWidths) {
    double worst = 0.0;
    for (const float lod : {0.01f, 0.02f, 0.1f, 0.3f, 0.5f, 0.7f, 0.83f, 0.9f, 0.99f, 1.0f}) {
        const Choice::Drawn level = levelOf(lod);
        double sum = 0.0;
        float last = 1e9f;
        for (uint i = 0; i < kRoots; ++i) {
            const float rank = rankOf(i, 0.5f, 1.0f / static_cast<float>(kRoots));
            const float width = rank < level.fade ? fadedWidth(rank, level.lod, level.fade) : 0.0f;
            EXPECT_LE(width, last);  // no hair is wider than one of lower rank
            sum += static_cast<double>(width);
            last = width;
        }
        worst = std::max(worst, std::abs(sum / kRoots - 1.0));
    }
    test::reached("R8", "sum of the widths, relative, levels of detail .01 to 1", worst, 1e-5);
}

TEST(Lod, AllHairsHaveTheirOwnWidth) {
    const Choice::Drawn level = levelOf(1.0f);
    for (const float rank : {0.0f, 0.3f, 0.8f, 0.99999994f})
        EXPECT_EQ(fadedWidth(rank, level.lod, level.fade), 1.0f) << rank;
}

TEST(Lod, HairsFadeInsteadOfVanishing) {
    float last[64];
    std::fill(std::begin(last), std::end(last), -1.0f);
    for (float lod = 0.83f; lod > 0.02f; lod *= 0.99f) {
        const Choice::Drawn level = levelOf(lod);
        for (uint i = 0; i < 64; ++i) {
            const float rank = (static_cast<float>(i) + 0.5f) / 64.0f;
            const float width = rank < level.fade ? fadedWidth(rank, level.lod, level.fade) : 0.0f;
            if (last[i] >= 0.0f) {
                EXPECT_LT(std::abs(width - last[i]), 0.06f / lod) << lod;
            }
            last[i] = width;
        }
    }
}

TEST(Lod, ClustersFarBelowAPixelStandForEachOther) {
    // A hundredth of a hair of each; together as many as of one large cluster.
    Roots roots = oneCluster(vec3(0.0f), 16);
    roots.clusters.assign(20000, roots.clusters[0]);
    for (uint c = 0; c < roots.clusters.size(); ++c) roots.clusters[c].phase = rand01(c);
    const Sight sight = sightFrom(vec3(0, 0, 800.0f * pixelDistance()));
    const Choice choice = choiceOf(roots, sight, pixels(0.5f));
    EXPECT_GT(choice.small, roots.clusters.size() * 9 / 10);
    EXPECT_EQ(choice.small + choice.clusters.size(), roots.clusters.size());
    double widths = 0.0;
    for (const Choice::Drawn& drawn : choice.clusters)
        for (uint i = 0; i < drawn.hairs; ++i)
            widths += static_cast<double>(
                fadedWidth(rankOf(i, roots.clusters[drawn.cluster].phase, 1.0f / 16.0f), drawn.lod,
                           drawn.fade));
    EXPECT_NEAR(widths / (16.0 * 20000.0), 1.0, 0.15);
}

TEST(Lod, APaintedDensityDrawsOnlyThePrefixThatCanGrow) {
    const Roots roots = oneCluster();
    const Sight sight = sightFrom(vec3(0, 0, 1));
    Tuft tuft{.longest = 0.1f, .densest = 0.25f};
    const InSight seen = lookAt(roots, {&tuft, 1}, plainPelt(), sight, &kNoSkin);
    EXPECT_EQ(choose(roots, seen, sight, plainPelt(), kAll, 0.0f, {}).hairs, kRoots / 4);
}

TEST(Lod, ATimeIsKeptByTheLeastDeviationThatFits) {
    const Sight sight = sightFrom(vec3(0, 0, 3));
    const InSight seen = seenOf(oneCluster(), sight, 0.05f);
    for (const Detail& detail : {kAll, Detail{}, pixels(0.2f)}) {
        const auto work = [&](float deviation) {
            return workOf(seen, sight, plainPelt(), detail, deviation, {});
        };
        const auto within = [&](double bound) {
            return deviationWithin(bound, seen, sight, plainPelt(), detail, {});
        };
        EXPECT_EQ(within(work(0.0f)), 0.0f);
        EXPECT_EQ(within(0.0), kMostDeviation);
        for (const float deviation : {0.3f, 1.0f, 5.0f}) {
            const float found = within(work(deviation));
            EXPECT_LE(found, 1.01f * deviation);
            EXPECT_LE(work(found), work(deviation));
            EXPECT_TRUE(found < 2e-3f || work(0.98f * found) > work(deviation)) << found;
        }
    }
}

TEST(Lod, WorkIsThatOfTheChoice) {
    const Sight sight = sightFrom(vec3(0, 0, 3));
    const InSight seen = seenOf(oneCluster(), sight, 0.05f);
    const Choice choice = choose(oneCluster(), seen, sight, plainPelt(), pixels(0.7f), 0.0f, {});
    EXPECT_EQ(choice.work, workOf(seen, sight, plainPelt(), pixels(0.7f), 0.0f, {}));
    EXPECT_GT(choice.work, 10.0 * static_cast<double>(choice.hairs) / 1.2);
}

// The farthest that the polyline through so many points of the hair strays from it, m.
float strayOf(const Strand& s, uint segments) {
    float worst = 0.0f;
    for (int i = 0; i <= 4000; ++i) {
        const float t = static_cast<float>(i) / 4000.0f;
        const float at = std::min(std::floor(t * static_cast<float>(segments)),
                                  static_cast<float>(segments) - 1.0f);
        const vec3 a = strandPoint(s, at / static_cast<float>(segments));
        const vec3 b = strandPoint(s, (at + 1.0f) / static_cast<float>(segments));
        const vec3 p = strandPoint(s, t);
        const float along = glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0f, 1.0f);
        worst = std::max(worst, glm::distance(p, glm::mix(a, b, along)));
    }
    return worst;
}

TEST(Lod, SegmentsKeepTheToleranceOnScreenOfHairsOfAnyLength) {
    Coat coat{};
    coat.stiffness = 0.02f;
    coat.directionWeight = 1.0f;
    for (const float angle : {0.1f, 0.7f, 1.4f}) {
        const vec3 combed(std::sin(angle), std::cos(angle), 0.0f);
        const Strand s =
            bendStrand(vec3(0.0f), vec3(0, 1, 0), combed, 1.0f, coat, 1u, vec3(0, -1, 0));
        for (const float tolerance : {0.25f, 0.5f})
            for (float length = 10.0f; length <= 1000.0f; length *= 1.3f) {  // pixels
                const uint segments = segmentsFor(s, tolerance / length);
                EXPECT_TRUE(strayOf(s, segments) * length <= 1.1f * tolerance || segments == 32)
                    << angle << " " << length;
                // One segment more or less: a step of the shape that is no larger.
                if (segments > 1) {
                    EXPECT_LE(strayOf(s, segments + 1) * length, tolerance);
                }
            }
    }
}

TEST(Lod, FewerSegmentsThanAskedOnlyWhereADeviationIsAllowed) {
    const Fineness otherwise{8, 0.3f, false};
    for (const Detail& detail : {kAll, Detail{}, share(0.5f)}) {
        EXPECT_FALSE(finenessOf(detail, 0.0f, otherwise).adapts);
        EXPECT_EQ(finenessOf(detail, 0.0f, otherwise).segments, 8u);
        EXPECT_TRUE(finenessOf(detail, 0.1f, otherwise).adapts);
        EXPECT_EQ(finenessOf(detail, 0.1f, otherwise).tolerance, 0.3f);
        EXPECT_EQ(finenessOf(detail, 2.0f, otherwise).tolerance, 2.0f);
    }
    EXPECT_TRUE(finenessOf(pixels(0.1f), 0.0f, otherwise).adapts);
    EXPECT_EQ(finenessOf(pixels(0.1f), 0.0f, otherwise).tolerance, 0.1f);
}

TEST(Lod, HairsAreNarrowWhereNoneIsWideEnoughToLookRound) {
    const float round = pixelDistance() / kRoundFrom;  // where they are
    const auto narrow = [&](float distance, const Detail& detail) {
        return choiceOf(oneCluster(), sightFrom(vec3(0, 0, distance)), detail)
            .clusters.at(0)
            .narrow;
    };
    EXPECT_FALSE(narrow(0.9f * round, kAll));
    EXPECT_TRUE(narrow(round + 0.02f, kAll));
    EXPECT_FALSE(narrow(round + 0.02f, share(0.5f)));  // which makes them wider
}

TEST(Lod, ACoatThatIsNotThereIsNoWork) {
    Fur fur = defaultFur();
    const auto coats = [&](uint asked) {
        return peltOf(fur, asked, 1e-4f, 1e-4f, 1.0, 0.1f).coats;
    };
    EXPECT_EQ(coats(3), 3u);
    EXPECT_EQ(coats(1), 1u);
    fur.share = 1.0f;
    EXPECT_EQ(coats(3), 1u);
    fur.share = 0.0f;
    EXPECT_EQ(coats(3), 2u);
    fur.under.relativeLength = 0.0f;
    EXPECT_EQ(coats(3), 0u);
    // Without any nothing is looked at.
    const Roots roots = oneCluster();
    const Tuft tuft{.longest = 1.0f, .densest = 1.0f};
    const InSight seen = lookAt(roots, {&tuft, 1}, peltOf(fur, 3, 1e-4f, 1e-4f, 1.0, 0.1f),
                                sightFrom(vec3(0, 0, 1)), &kNoSkin);
    EXPECT_TRUE(seen.clusters.empty());
    EXPECT_EQ(seen.bald, 1u);
}

}  // namespace
}  // namespace pelage
