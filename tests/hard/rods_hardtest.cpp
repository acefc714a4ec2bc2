// rods_hardtest.cpp -- elastic rods where they buckle, hang over, or would pass through the skin.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "core/coat.h"
#include "core/strand.h"
#include "rods.h"
#include "test_skins.h"

namespace pelage {
namespace {

using test::kDown, test::rodCoat;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

// How deep the spine goes below the plane of its root before it is lifted, in its lengths.
float depthOf(const Strand& s) {
    float deepest = 0.0f;
    for (int i = 1; i <= 10; ++i) {
        const vec2 k = strandWeights(s, static_cast<float>(i) / 10.0f);
        deepest =
            std::max(deepest, -s.scale * glm::dot(k.x * s.weightless + k.y * s.end, s.normal));
    }
    return deepest;
}

// Hair that leans so far from the skin's normal, which points anywhere.
struct Leaning {
    vec3 n, w;

    Leaning(test::Draws& draws, float degrees) {
        n = safeUnit(draws.inBox(1.0f), vec3(0, 1, 0));
        const vec3 t = safeUnit(glm::cross(n, draws.inBox(1.0f)), anyTangent(n));
        w = std::cos(glm::radians(degrees)) * n + std::sin(glm::radians(degrees)) * t;
    }
};

TEST(HardRods, StayAboveTheSkinAMillionHairs) {
    test::Draws draws(1);
    float deepest = 0.0f;
    std::size_t hairs = 0, deep = 0;
    while (hairs < 1'000'000) {
        const Leaning at(draws, draws.in(0.0f, 80.0f));
        const Coat coat = rodCoat(draws.in(0.0f, 1.0f), draws.in(0.0f, 0.3f));
        if (rodLoad(coat, glm::dot(at.n, at.w), 1.0f) > 50.0f) continue;
        ++hairs;
        const float depth = depthOf(bendStrand(vec3(0), at.n, at.w, 1.0f, coat, 1u, kDown));
        deepest = std::max(deepest, depth);
        deep += depth > 1e-4f;
    }
    std::printf("%zu hairs, deepest %.2g before they are lifted\n", hairs,
                static_cast<double>(deepest));
    EXPECT_EQ(deep, 0u);
}

TEST(HardRods, NearlyFlatHairIsLiftedOntoTheSkin) {
    test::Draws draws(2);
    float before = 0.0f, after = 0.0f;
    for (int i = 0; i < 100'000; ++i) {
        const Leaning at(draws, draws.in(80.0f, 90.0f));
        const Strand s =
            bendStrand(vec3(0), at.n, at.w, 1.0f, rodCoat(0.0f, draws.in(0.0f, 1.0f)), 1u, kDown);
        before = std::max(before, depthOf(s));
        for (const float t : {0.3f, 0.7f, 1.0f})
            after = std::max(after, -glm::dot(strandPoint(s, t), at.n));
    }
    std::printf("deepest %.2g before, %.2g after\n", static_cast<double>(before),
                static_cast<double>(after));
    EXPECT_LT(before, 0.011f);
    EXPECT_LT(after, 1e-6f);
}

TEST(HardRods, EveryInputGivesAFiniteRodAMillionTimes) {
    const std::vector<float> numbers{0.0f,  -0.0f, 1e-45f, 1e-38f, 1e-20f, 1e-6f, 0.02f, 0.5f,
                                     0.98f, 1.0f,  -1.0f,  2.0f,   1e20f,  kInf,  -kInf, kNan};
    test::Draws draws(3);
    const auto pick = [&] { return numbers[draws.below(static_cast<uint>(numbers.size()))]; };
    const auto mixed = [&] { return draws.below(3) == 0 ? draws.in(-1.0f, 1.0f) : pick(); };
    for (int i = 0; i < 1'000'000; ++i) {
        const vec3 n = safeUnit(vec3(mixed(), mixed(), mixed()), vec3(0, 1, 0));
        Coat coat = rodCoat(mixed(), mixed());
        coat.directionWeight = mixed();
        coat.endRandomness = mixed();
        coat.style = draws.below(5);
        Fur fur = defaultFur();
        fur.gravity = mixed();
        fur.wind = mixed();
        const vec3 pull = pullAt(fur, vec3(0), 0.0f);
        const Strand s = bendStrand(vec3(0), n, vec3(mixed(), mixed(), mixed()), 1.0f, coat,
                                    draws.below(99), pull);
        for (const float t : {0.0f, 0.3f, 1.0f}) {
            const vec3 p = strandPoint(s, t), along = strandTangent(s, t);
            ASSERT_TRUE(std::isfinite(glm::dot(p, p))) << i;
            ASSERT_LT(glm::length(p), 1.001f) << i;
            ASSERT_GT(glm::dot(p, n), -2e-6f) << i;
            ASSERT_NEAR(glm::length(along), 1.0f, 1e-5f) << i;
        }
        const uint segments = segmentsFor(s, 1e-3f);
        ASSERT_TRUE(segments >= 1 && segments <= 32) << i;
    }
}

}  // namespace
}  // namespace pelage
