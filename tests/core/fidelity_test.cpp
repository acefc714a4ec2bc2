// fidelity_test.cpp -- how coarse a picture may be for its error: guesses that are smooth, and
// pictures that keep what is asked for however wrong the guess was.
#include "core/fidelity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/sights.h"

namespace pelage {
namespace {

FurInView shownFrom(float distance) {
    const Roots roots = test::oneCluster();
    const Sight sight = test::sightFrom(vec3(0, 0, distance));
    return furInView(roots, test::seenOf(roots, sight), sight, test::plainPelt());
}

TEST(Fidelity, ErrorsGrowWithTheDeviationAndAllHairsHaveNone) {
    const Fidelity fidelity;
    for (const float pixels : {0.01f, 1.0f, 10.0f}) {
        const FurInView fur{0.3f, pixels};
        EXPECT_EQ(fidelity.flipAt(0.0f, fur), 0.0f);
        float last = 0.0f;
        for (float deviation = kFinest; deviation < 20.0f; deviation *= 1.1f) {
            const float flip = fidelity.flipAt(deviation, fur);
            EXPECT_GT(flip, last) << deviation;
            last = flip;
        }
    }
}

TEST(Fidelity, TheDeviationIsTheGreatestThatKeepsTheError) {
    const Fidelity fidelity;
    for (const float asked : {0.001f, 0.02f, 0.05f, 0.3f})
        for (const FurInView fur :
             {FurInView{1.0f, 0.5f}, FurInView{0.2f, 0.05f}, FurInView{0.01f, 0.01f}}) {
            const float deviation = fidelity.deviationWithin(asked, fur);
            EXPECT_LE(fidelity.flipAt(deviation, fur), asked);
            EXPECT_LE(deviation, kCoarsest);
            EXPECT_TRUE(deviation == 0.0f || deviation >= kFinest);
            if (deviation < kCoarsest) {
                const float next = std::max(kFinest, 1.01f * deviation);
                EXPECT_GT(fidelity.flipAt(next, fur), 0.85f * asked);
            }
        }
}

TEST(Fidelity, NoErrorBuysMoreThanAPixelHoweverSmallTheFurIs) {
    for (const float asked : {0.02f, 0.5f, 1.0f})
        for (const float share : {1e-6f, 1e-3f, 0.1f}) {
            Fidelity fidelity;
            const FurInView fur{share, 0.02f};
            // Nor where pictures turned out to have hardly an error.
            for (int picture = 0; picture < 20; ++picture) {
                const float deviation = fidelity.deviationWithin(asked, fur);
                EXPECT_LE(deviation, 1.0f) << asked << " " << share;
                fidelity.learn(asked, 1e-6f, deviation, fur);
            }
            EXPECT_EQ(fidelity.deviationWithin(asked, fur), 1.0f);
        }
}

TEST(Fidelity, ASmallStepOfTheCameraChangesLittle) {
    const Fidelity fidelity;
    constexpr float kStep = 1.001f;
    float last = 0.0f;
    for (float distance = 0.02f; distance < 2.0f; distance *= kStep) {
        const float deviation = fidelity.deviationWithin(0.01f, shownFrom(distance));
        if (last > 0.0f && deviation > 0.0f) {
            EXPECT_NEAR(deviation / last, 1.0f, 0.02f) << distance;
        }
        last = deviation;
    }
}

TEST(Fidelity, FurCoversLessOfThePictureFartherAway) {
    // The box around the cluster and its hair, which is as long as 1/20 of its diameter.
    for (const float distance : {0.5f, 1.0f, 4.0f}) {
        const float pixels =
            2.0f * 0.0105f * test::sightFrom(vec3(0, 0, 1)).pixelsPerMetre / distance;
        const FurInView fur = shownFrom(distance);
        EXPECT_LT(fur.share, 1.05f * pixels * pixels / (500.0f * 500.0f)) << distance;
        EXPECT_GT(fur.share, 0.5f * pixels * pixels / (500.0f * 500.0f)) << distance;
    }
    EXPECT_LE(shownFrom(0.02f).share, 1.0f);
    EXPECT_EQ(furInView({}, {}, test::sightFrom(vec3(0, 0, 1)), test::plainPelt()).share, 0.0f);
}

// Coats on which errors grow in another way than is guessed.
TEST(Fidelity, PicturesMadeAnewKeepTheErrorSoonOnAnyCoat) {
    const FurInView fur{0.4f, 0.3f};
    for (const float scale : {1e-3f, 0.05f, 0.3f, 3.0f})
        for (const float power : {0.1f, 0.4f, 1.0f, 2.0f}) {
            Fidelity fidelity;
            int pictures = 0;
            for (;; ++pictures) {
                const float deviation = fidelity.deviationWithin(0.05f, fur);
                const float error = scale * std::pow(deviation, power);
                if (error <= 0.05f) break;
                fidelity.learn(0.05f, error, deviation, fur);
                ASSERT_LT(pictures, 40) << scale << " " << power;
            }
            if (power > 0.3f && power < 1.5f) {
                EXPECT_LE(pictures, 4) << scale << " " << power;
            }
        }
}

TEST(Fidelity, WhatWasLearntHoldsForTheNextPicture) {
    const FurInView fur{0.4f, 0.3f};
    Fidelity fidelity;
    const float before = fidelity.deviationWithin(0.05f, fur);
    fidelity.learn(0.05f, 0.5f * fidelity.flipAt(before, fur), before, fur);
    EXPECT_GT(fidelity.deviationWithin(0.05f, fur), before);
    EXPECT_NEAR(fidelity.flipAt(before, fur), 0.5f * Fidelity{}.flipAt(before, fur), 1e-5f);
}

}  // namespace
}  // namespace pelage
