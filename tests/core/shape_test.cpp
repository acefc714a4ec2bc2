// shape_test.cpp -- styles, clumps, curls, frizz and wind.
#include <gtest/gtest.h>

#include <cmath>

#include "core/clumps.h"
#include "core/coat.h"
#include "core/strand.h"
#include "test_skins.h"

namespace pelage {
namespace {

const vec3 kUp(0, 1, 0), kDown(0, -1, 0);

Coat plainCoat() {
    Coat coat = defaultFur().over;
    coat.endRandomness = 0.0f;
    return coat;
}

double length(const Strand& s, int steps = 4000) {
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
        sum += static_cast<double>(
            glm::distance(strandPoint(s, static_cast<float>(i) / static_cast<float>(steps)),
                          strandPoint(s, static_cast<float>(i + 1) / static_cast<float>(steps))));
    return sum;
}

TEST(Shape, ALineRunsStraightFromRootToEnd) {
    Coat coat = plainCoat();
    coat.stiffness = 0.1f;
    const Strand curve = bendStrand(vec3(1), vec3(1, 0, 0), vec3(0, 0, 1), 0.2f, coat, 3, kDown);
    coat.style = kStyleLine;
    const Strand line = bendStrand(vec3(1), vec3(1, 0, 0), vec3(0, 0, 1), 0.2f, coat, 3, kDown);
    EXPECT_NEAR(glm::distance(strandPoint(line, 1.0f), vec3(1)), 0.2f, 1e-6f);
    EXPECT_LT(glm::distance(line.end, curve.end), 1e-6f);
    for (const float t : {0.1f, 0.5f, 0.9f})
        EXPECT_LT(glm::distance(strandPoint(line, t), vec3(1) + 0.2f * t * line.end), 1e-6f);
    EXPECT_EQ(strandNormal(line, strandTangent(line, 0.5f)), vec3(1, 0, 0));  // the skin's
}

TEST(Shape, ACurveIsTheCubicBezierOfItsFourControlPoints) {
    test::Draws draws(4);
    Coat coat = plainCoat();
    for (const uint style : {kStyleCurve, kStyleTube, kStyleRibbon}) {
        coat.style = style;
        for (int i = 0; i < 100; ++i) {
            const Strand s =
                bendStrand(vec3(0), glm::normalize(draws.inBox(1.0f) + vec3(0, 1.8f, 0)),
                           draws.inBox(1.0f), 1.0f, coat, static_cast<uint>(i), kDown);
            // De Casteljau on 0, w/3, (w + E)/3, E, method.md's template of Figure 3.
            const glm::dvec3 w(s.weightless), e(s.end);
            for (const double t : {0.0, 0.2, 0.5, 0.77, 1.0}) {
                glm::dvec3 p[4] = {glm::dvec3(0), w / 3.0, (w + e) / 3.0, e};
                for (int level = 3; level > 0; --level)
                    for (int k = 0; k < level; ++k) p[k] = glm::mix(p[k], p[k + 1], t);
                const vec3 wanted(p[0] * static_cast<double>(s.scale));
                ASSERT_LT(glm::distance(strandPoint(s, static_cast<float>(t)), wanted), 1e-6f);
            }
        }
    }
}

TEST(Shape, CurlsKeepTheLengthOfAStraightHair) {
    Coat coat = plainCoat();
    coat.stiffness = 1.0f;
    coat.directionWeight = 0.0f;
    for (const float radius : {0.01f, 0.05f, 0.2f, 0.5f})
        for (const float turns : {0.0f, 1.0f, 3.0f, 20.0f}) {
            coat.curlRadius = radius;
            coat.curlTurns = turns;
            const Strand s = bendStrand(vec3(0), kUp, vec3(0), 0.1f, coat, 7, vec3(0));
            EXPECT_NEAR(length(s, 20000) / 0.1, 1.0, 2e-4) << radius << " " << turns;
        }
}

TEST(Shape, CurlAndFrizzGrowFromNothingAtTheRoot) {
    Coat coat = plainCoat();
    coat.curlRadius = 0.3f;
    coat.curlTurns = 4.0f;
    coat.frizz = 0.3f;
    const Strand s = bendStrand(vec3(2, 3, 4), kUp, vec3(0), 0.1f, coat, 7, kDown);
    EXPECT_EQ(strandPoint(s, 0.0f), vec3(2, 3, 4));
    const float far = glm::distance(strandPoint(s, 1.0f), spinePoint(s, 1.0f));
    EXPECT_GT(far, 0.01f);
    EXPECT_LT(glm::distance(strandPoint(s, 0.1f), spinePoint(s, 0.1f)), 0.25f * far + 0.006f);
}

TEST(Shape, FrizzIsSmoothAndDiffersFromHairToHair) {
    Coat coat = plainCoat();
    coat.frizz = 0.4f;
    coat.frizzWaves = 16.0f;
    const Strand a = bendStrand(vec3(0), kUp, vec3(0), 1.0f, coat, 7, vec3(0));
    const Strand b = bendStrand(vec3(0), kUp, vec3(0), 1.0f, coat, 8, vec3(0));
    EXPECT_GT(glm::distance(strandPoint(a, 1.0f), strandPoint(b, 1.0f)), 0.01f);
    for (int i = 0; i < 1000; ++i) {
        const float t = static_cast<float>(i) / 1000.0f;
        ASSERT_LT(glm::distance(strandPoint(a, t), strandPoint(a, t + 0.001f)), 0.04f);
    }
}

TEST(Shape, TangentsFollowTheShapedHair) {
    Coat coat = plainCoat();
    coat.curlRadius = 0.1f;
    coat.curlTurns = 2.0f;
    coat.frizz = 0.05f;
    const Strand s = bendStrand(vec3(0), kUp, vec3(0, 0, 1), 1.0f, coat, 7, kDown);
    for (int i = 1; i < 50; ++i) {
        const float t = static_cast<float>(i) / 50.0f;
        const vec3 ahead = strandPoint(s, t + 1e-3f) - strandPoint(s, t - 1e-3f);
        EXPECT_GT(glm::dot(strandTangent(s, t), glm::normalize(ahead)), 0.98f) << t;
    }
}

TEST(Shape, NothingDipsBelowThePlaneOfTheRoot) {
    test::Draws draws(9);
    for (int i = 0; i < 3000; ++i) {
        Coat coat = plainCoat();
        coat.stiffness = draws.in(0.0f, 1.0f);
        coat.clump = draws.in(0.0f, 1.0f);
        coat.curlRadius = draws.in(0.0f, 0.5f);
        coat.curlTurns = draws.in(0.0f, 20.0f);
        coat.frizz = draws.in(0.0f, 0.5f);
        const vec3 n = glm::normalize(draws.inBox(1.0f) + vec3(0, 0.01f, 0));
        Strand s = bendStrand(vec3(0), n, draws.inBox(1.0f), 1.0f, coat, static_cast<uint>(i),
                              glm::normalize(draws.inBox(1.0f) + vec3(0, 0.01f, 0)));
        const Strand guide = bendStrand(draws.inBox(0.5f), glm::normalize(draws.inBox(1.0f) + 0.01f),
                                        draws.inBox(1.0f), 1.0f, coat, 3, kDown);
        s = gatherStrand(s, guide, coat);
        for (int k = 0; k <= 40; ++k)
            ASSERT_GT(glm::dot(strandPoint(s, static_cast<float>(k) / 40.0f), n), -2e-6f) << i;
    }
}

TEST(Shape, ChordErrorBoundsTheStrayOfThePolyline) {
    test::Draws draws(5);
    for (int i = 0; i < 300; ++i) {
        Coat coat = plainCoat();
        coat.stiffness = draws.in(0.0f, 1.0f);
        const Strand s = bendStrand(vec3(0), glm::normalize(draws.inBox(1.0f) + vec3(0, 0.01f, 0)),
                                    draws.inBox(1.0f), 1.0f, coat, static_cast<uint>(i), kDown);
        const int n = 1 + i % 8;
        float worst = 0.0f;
        for (int k = 0; k < n; ++k) {
            const float from = static_cast<float>(k) / static_cast<float>(n);
            const float to = static_cast<float>(k + 1) / static_cast<float>(n);
            const vec3 middle = 0.5f * (strandPoint(s, from) + strandPoint(s, to));
            worst = std::max(worst, glm::distance(middle, strandPoint(s, 0.5f * (from + to))));
        }
        const float bound = chordError(s, static_cast<float>(n));
        EXPECT_LE(worst, bound * 1.001f + 1e-6f);
        EXPECT_GE(worst, bound * 0.98f - 1e-6f);
    }
}

TEST(Shape, SegmentsKeepTheTolerance) {
    Coat coat = plainCoat();
    coat.stiffness = 0.0f;
    const Strand s = bendStrand(vec3(0), vec3(1, 0, 0), vec3(0, 0, 1), 1.0f, coat, 1, kDown);
    for (const float tolerance : {0.1f, 0.01f, 0.001f}) {
        const uint n = segmentsFor(s, tolerance);
        EXPECT_LE(chordError(s, static_cast<float>(n)), tolerance * 1.0001f);
        if (n > 1) {
            EXPECT_GT(chordError(s, static_cast<float>(n - 1)), tolerance);
        }
    }
    EXPECT_EQ(segmentsFor(s, 1e-12f), 32u);
    EXPECT_EQ(segmentsFor(s, 0.0f), 32u);
}

TEST(Shape, RingsOfATubeAreAsWideOnAverageAsTheHair) {
    const Strand s = bendStrand(vec3(0), kUp, vec3(1, 0, 0), 1.0f, plainCoat(), 1, kDown);
    const vec3 tangent = strandTangent(s, 0.4f);
    for (const uint sides : {3u, 4u, 6u, 8u}) {
        double sum = 0.0;
        const int views = 720;
        for (int i = 0; i < views; ++i) {
            const vec3 n = tubeNormal(s, tangent, 0, sides);
            const float turn = 6.2831853f * static_cast<float>(i) / views;
            const vec3 across = std::cos(turn) * n + std::sin(turn) * glm::cross(tangent, n);
            float least = 1e9f, most = -1e9f;
            for (uint k = 0; k < sides; ++k) {
                const vec3 corner = tubeNormal(s, tangent, k, sides);
                EXPECT_NEAR(glm::dot(corner, tangent), 0.0f, 1e-5f);
                EXPECT_NEAR(glm::length(corner), 1.0f, 1e-5f);
                least = std::min(least, glm::dot(corner, across));
                most = std::max(most, glm::dot(corner, across));
            }
            sum += static_cast<double>(tubeScale(sides) * (most - least));
        }
        EXPECT_NEAR(sum / views, 2.0, 2e-3) << sides;
    }
}

TEST(Shape, WindAndGravityTogetherPullNoHarderThanGravityAlone) {
    test::Draws draws(6);
    Fur fur = defaultFur();
    for (int i = 0; i < 2000; ++i) {
        fur.wind = draws.in(0.0f, 1.0f);
        fur.gusts = draws.in(0.0f, 1.0f);
        fur.gravity = draws.in(0.0f, 1.0f);
        fur.windDirection = glm::normalize(draws.inBox(1.0f) + vec3(0.01f));
        EXPECT_LE(glm::length(pullAt(fur, draws.inBox(10.0f), draws.in(0.0f, 1e4f))), 1.000001f);
    }
    fur.wind = 0.0f;
    fur.gravity = 0.7f;
    EXPECT_EQ(pullAt(fur, vec3(1, 2, 3), 9.0f), 0.7f * fur.gravityDirection);
}

// Of hair by the paper's rule; the length stays, so that a strong wind pulls tips down as well.
TEST(Shape, WindMovesAPointOfAHairByTheSquareOfItsWayToTheTip) {
    const vec3 up(0.0f, 1.0f, 0.0f);
    Coat coat = defaultFur().over;
    coat.stiffness = 0.3f;
    coat.endRandomness = 0.0f;
    const auto hair = [&](float wind) {
        return bendStrand(vec3(0.0f), up, vec3(0.0f), 0.1f, coat, 1u, vec3(wind, 0.0f, 0.0f));
    };
    const Strand calm = hair(0.1f), blown = hair(0.15f);
    const auto moved = [&](float t) { return strandPoint(blown, t) - strandPoint(calm, t); };
    EXPECT_EQ(moved(0.0f), vec3(0.0f));
    EXPECT_GT(moved(1.0f).x, 0.003f);
    for (const float t : {0.25f, 0.5f, 0.75f})
        EXPECT_NEAR(moved(t).x / moved(1.0f).x, t * t, 0.02f) << t;
}

TEST(Shape, GustsAreSmoothAndTravel) {
    Fur fur = defaultFur();
    fur.gravity = 0.0f;
    fur.wind = 0.4f;
    fur.gusts = 1.0f;
    float least = 1.0f, most = 0.0f;
    for (int i = 0; i < 2000; ++i) {
        const float time = 0.01f * static_cast<float>(i);
        const float now = glm::length(pullAt(fur, vec3(0.1f), time));
        const float then = glm::length(pullAt(fur, vec3(0.1f), time + 0.01f));
        EXPECT_LT(std::abs(now - then), 0.02f);
        least = std::min(least, now);
        most = std::max(most, now);
    }
    EXPECT_LT(least, 0.25f);
    EXPECT_GT(most, 0.5f);
}

Fur clumping(float size) {
    Fur fur = defaultFur();
    for (Coat* coat : {&fur.over, &fur.under}) {
        coat->clump = 0.5f;
        coat->clumpSize = size;
    }
    return fur;
}

TEST(Clumps, HoldAsManyHairsAsAskedOnAverage) {
    const auto skin = makeSkin(test::ball(4));
    for (const float size : {2.0f, 20.0f, 300.0f}) {
        const Fur fur = clumping(size);
        Roots roots = scatterRoots(*skin, 60000, 1);
        assignGuides(roots, *skin, fur);
        std::size_t guides = 0;
        for (uint i = 0; i < roots.roots.size(); ++i) guides += roots.roots[i].guide == i;
        const double perGuide =
            static_cast<double>(roots.roots.size()) / static_cast<double>(guides);
        EXPECT_NEAR(perGuide / static_cast<double>(size), 1.0, 0.15) << size;
    }
}

TEST(Clumps, GatherToTheNearestGuideOfTheSameCoatOnTheSameSide) {
    const auto skin = makeSkin(test::twoSheets(16, 0.001f));
    const Fur fur = clumping(30.0f);
    Roots roots = scatterRoots(*skin, 5000, 1);
    assignGuides(roots, *skin, fur);
    const auto place = [&](const Root& r) {
        const uvec3 t = skin->triangles[r.triangle];
        const vec3 w = baryWeights(r.bary);
        return w.x * skin->vertices[t.x].position + w.y * skin->vertices[t.y].position +
               w.z * skin->vertices[t.z].position;
    };
    const auto normal = [&](const Root& r) {
        return skin->vertices[skin->triangles[r.triangle].x].normal;
    };
    std::vector<uint> guides;
    for (uint i = 0; i < roots.roots.size(); ++i)
        if (roots.roots[i].guide == i) guides.push_back(i);
    std::size_t farther = 0;
    for (const Root& root : roots.roots) {
        const Root& guide = roots.roots[root.guide];
        ASSERT_EQ(roots.roots[guide.guide].id, guide.id);  // a guide gathers to none
        ASSERT_EQ(isOvercoat(root.id, fur.share), isOvercoat(guide.id, fur.share));
        ASSERT_GT(glm::dot(normal(root), normal(guide)), 0.0f);
        const float distance = glm::distance(place(root), place(guide));
        for (const uint g : guides) {
            const Root& other = roots.roots[g];
            if (isOvercoat(other.id, fur.share) != isOvercoat(root.id, fur.share)) continue;
            if (!(glm::dot(normal(root), normal(other)) > 0.0f)) continue;
            farther += glm::distance(place(root), place(other)) < distance - 1e-6f;
        }
    }
    EXPECT_LT(farther, roots.roots.size() / 100);  // beyond the neighbouring cells nobody looks
}

TEST(Clumps, WithoutClumpingEveryHairIsItsOwnGuide) {
    const auto skin = makeSkin(test::ball(3));
    Roots roots = scatterRoots(*skin, 5000, 1);
    assignGuides(roots, *skin, clumping(10.0f));
    assignGuides(roots, *skin, defaultFur());
    for (uint i = 0; i < roots.roots.size(); ++i) ASSERT_EQ(roots.roots[i].guide, i);
}

TEST(Clumps, GuidesDifferOnlyWhereClumpsDo) {
    const Fur plain = defaultFur(), clumped = clumping(10.0f);
    Fur other = plain;
    other.over.clumpSize = 99.0f;  // of a coat that does not clump
    EXPECT_FALSE(guidesDiffer(plain, other));
    EXPECT_TRUE(guidesDiffer(plain, clumped));
    other = clumped;
    other.under.clump = 0.9f;  // how much, not which
    EXPECT_FALSE(guidesDiffer(clumped, other));
    other.share = 0.9f;
    EXPECT_TRUE(guidesDiffer(clumped, other));
}

}  // namespace
}  // namespace pelage
