// rods_hardtest.cpp -- elastic rods where they buckle, hang over, or would pass through the skin.
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/coat.h"
#include "core/elastica.h"
#include "core/strand.h"
#include "core/strands_out.h"
#include "hair_check.h"
#include "rods.h"
#include "test_skins.h"
#include "tests/figures.h"

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
    EXPECT_EQ(deep, 0u);
    test::reached("H8",
                  "depth under the skin of 1,000,000 rods that lean to 80 degrees, load to 50",
                  deepest, 1e-4);
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
    EXPECT_LT(before, 0.011f);
    test::reached("H8", "the same, leaning 80 to 90 degrees, any load", after, 1e-6);
}

// True if hair of numbers that may be anything is finite, above its root's plane and within reach.
bool isSound(test::Draws& draws, uint droop) {
    constexpr float kNumbers[] = {0.0f,  -0.0f, 1e-45f, 1e-38f, 1e-20f, 1e-6f, 0.02f, 0.5f,
                                  0.98f, 1.0f,  -1.0f,  2.0f,   1e20f,  kInf,  -kInf, kNan};
    const auto mixed = [&] {
        return draws.below(3) == 0 ? draws.in(-1.0f, 1.0f) : kNumbers[draws.below(16)];
    };
    const vec3 n = safeUnit(vec3(mixed(), mixed(), mixed()), vec3(0, 1, 0));
    Coat coat = rodCoat(mixed(), mixed());
    coat.droop = droop;
    coat.directionWeight = mixed();
    coat.endRandomness = mixed();
    coat.style = draws.below(5);
    Fur fur = defaultFur();
    fur.gravity = mixed();
    fur.wind = mixed();
    const vec3 pull = pullAt(fur, vec3(0), 0.0f);
    const Strand s =
        bendStrand(vec3(0), n, vec3(mixed(), mixed(), mixed()), 1.0f, coat, draws.below(99), pull);
    for (const float t : {0.0f, 0.3f, 1.0f}) {
        const vec3 p = strandPoint(s, t), along = strandTangent(s, t);
        if (!std::isfinite(glm::dot(p, p)) || !(glm::length(p) < 1.001f)) return false;
        if (!(glm::dot(p, n) > -1e-4f)) return false;
        if (!(std::abs(glm::length(along) - 1.0f) < 1e-4f)) return false;
    }
    const uint segments = segmentsFor(s, 1e-3f);
    return segments >= 1 && segments <= 32;
}

TEST(HardRods, EveryInputGivesAFiniteHairTenMillionTimes) {
    std::atomic<int> unsound = 0;
    tbb::parallel_for(0u, 1000u, [&](uint part) {
        test::Draws draws(part);
        for (uint i = 0; i < 10'000; ++i)
            unsound += !isSound(draws, i % 2 == 0 ? kDroopPaper : kDroopElastica);
    });
    test::reached("H13", "10,000,000 hairs of both kinds from NaN, infinite and denormal: unsound",
                  unsound, 0.0);
}

// Milliseconds, the least of five.
template <class Work>
double costOf(const Work& work) {
    double least = 1e9;
    for (int i = 0; i < 5; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double, std::milli> took =
            std::chrono::steady_clock::now() - start;
        least = std::min(least, took.count());
    }
    return least;
}

// Costs depend on the machine: they are said, not expected.
TEST(HardRods, HalfAMillionOfThemCostSoMuch) {
    using test::measured;
    float sum = rodTable()->x;  // made here, not in what is timed
    const double lookUps = costOf([&] {
        for (uint i = 0; i < 100'000; ++i) sum += rodCurve(rand01(i), rand01(i + 1000u))[2].x;
    });
    EXPECT_TRUE(std::isfinite(sum));
    measured("H14", "cost of the table of rods (nanoseconds a hair and core)", 10.0 * lookUps,
             40.0);
    Document document = test::evenDocument(test::ball(6));
    document.fur.hairs = 500'000;
    for (uint v = 0; v < document.skin->vertices.size(); ++v)
        document.groom.fur.edit(v).density = 1.0f;  // all of them grow
    const Roots roots = test::rootsOf(document, 2);
    double cost[2];
    for (const uint droop : {kDroopPaper, kDroopElastica}) {
        document.fur.over.droop = document.fur.under.droop = droop;
        cost[droop] = costOf([&] { growCurves(document, roots, 8); });
    }
    measured("H14", "500,000 hairs of the paper's rule, 8 segments (milliseconds)", cost[0], 50.0);
    measured("H14", "500,000 rods (milliseconds)", cost[1], 50.0);
    measured("H14", "rods over hairs of the paper's rule", cost[1] / cost[0], 1.5);
}

}  // namespace
}  // namespace pelage
