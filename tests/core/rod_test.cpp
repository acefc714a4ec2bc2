// rod_test.cpp -- hair as elastic rods (shaders/rod.glsl), against the solver and its promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <vector>

#include "core/coat.h"
#include "core/elastica.h"
#include "core/shape_error.h"
#include "core/strand.h"
#include "rods.h"
#include "test_skins.h"
#include "tests/figures.h"

namespace pelage {
namespace {

using test::kDown, test::rodCoat;

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180.0;

// A hair of length 1 that leaves a skin of normal n towards w.
Strand rodHair(vec3 n, vec3 w, const Coat& coat) {
    return bendStrand(vec3(0), n, w, 1.0f, coat, 1u, kDown);
}

// The same under this load.
Strand rodHair(vec3 n, vec3 w, float load) {
    const auto coatAt = [](float x) {
        return rodCoat(std::max(0.0f, 1.0f - x), std::max(0.0f, x - 1.0f));
    };
    const float c = glm::dot(n, w);
    float least = 0.0f, most = 2.0f;
    for (int i = 0; i < 30; ++i) {
        const float x = 0.5f * (least + most);
        (rodLoad(coatAt(x), c, 1.0f) < load ? least : most) = x;
    }
    return rodHair(n, w, coatAt(most));
}

vec3 directionAt(double fromUp, double turn = 0.0) {
    return vec3(std::sin(fromUp) * std::cos(turn), std::cos(fromUp),
                std::sin(fromUp) * std::sin(turn));
}

double farthest(const Strand& a, const Strand& b) {
    double worst = 0.0;
    for (int i = 1; i <= 16; ++i) {
        const float t = static_cast<float>(i) / 16.0f;
        worst = std::max<double>(worst, glm::distance(strandPoint(a, t), strandPoint(b, t)));
    }
    return worst;
}

// Distance of a curve from its chord between t and t + dt.
double chordDistance(const mat3x4& curve, float t, float dt) {
    const glm::dvec2 a(rodWeights(curve, t)), b(rodWeights(curve, t + dt));
    const glm::dvec2 along = glm::normalize(b - a);
    double worst = 0.0;
    for (int i = 1; i < 16; ++i) {
        const glm::dvec2 p =
            glm::dvec2(rodWeights(curve, t + dt * static_cast<float>(i) / 16.0f)) - a;
        worst = std::max(worst, std::abs(p.x * along.y - p.y * along.x));
    }
    return worst;
}

double chordDistance(const mat3x4& curve, uint chords) {
    double worst = 0.0;
    const float dt = 1.0f / static_cast<float>(chords);
    for (uint i = 0; i < chords; ++i)
        worst = std::max(worst, chordDistance(curve, static_cast<float>(i) * dt, dt));
    return worst;
}

// Angles from .05 to 179 degrees, closer near up, and loads, closer near 0, as hair takes them.
template <class Look>
void overRods(int angles, int loads, const Look& look) {
    for (int i = 0; i < angles; ++i)
        for (int j = 0; j < loads; ++j) {
            const double root = (0.05 + 178.95 * std::pow((i + 0.37) / angles, 1.5)) * kDegree;
            const double y = (j + 0.41) / loads * 1000.0 / 1010.0, load = 10.0 * y / (1.0 - y);
            look(root, load, load * static_cast<double>(rodFade(static_cast<float>(root))));
        }
}

mat3x4 curveOf(double root, double load) {
    return rodCurve(rodColumn(static_cast<float>(root)), rodRow(static_cast<float>(load)));
}

TEST(Rod, AnglesAndCubeRootsAreThoseOfTheLibrary) {
    for (int i = 0; i <= 3000; ++i) {
        const double angle = kPi * i / 3000.0;
        EXPECT_NEAR(
            angleOf(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))),
            angle, 4e-7);
        const float x = static_cast<float>(i) / 3000.0f;
        EXPECT_NEAR(cubeRoot(x), std::cbrt(x), 2e-7);
    }
    for (const double tiny : {1e-3, 1e-5, 1e-9})
        EXPECT_NEAR(angleOf(1.0f, static_cast<float>(tiny)) / tiny, 1.0, 1e-6);
}

TEST(Rod, TableIsWithinItsBoundsOfTheSolver) {
    std::vector<double> errors;
    overRods(45, 40, [&](double root, double, double faded) {
        errors.push_back(tableShapeError(root, faded));
    });
    std::sort(errors.begin(), errors.end());
    double mean = 0.0;
    for (const double e : errors) mean += e / static_cast<double>(errors.size());
    const double p99 = errors[errors.size() * 99 / 100];
    using test::reached;
    reached("H4", "table of rods against the solver, .05 to 179 degrees, loads to 1000: mean", mean,
            5e-4);
    reached("H4", "the same, 99 % of the cases", p99, 3e-3);
    reached("H4", "the same, at worst", errors.back(), 8e-3);
}

TEST(Rod, EveryCellOfTheTableIsWithinItsBoundOrOutOfReach) {
    double worst = 0.0;
    std::size_t marked = 0;
    for (const ShapeError& e : shapeErrors()) {
        if (e.part != ShapeError::Part::table) continue;
        if (e.used) {
            worst = std::max(worst, e.error);
            continue;
        }
        ++marked;  // stiffer so near upright: no hair takes such a load
        EXPECT_LT(kMostLoad * rodFade(static_cast<float>(e.root)), static_cast<float>(e.load));
    }
    EXPECT_GT(marked, 0u);
    test::reached("H4", "the same in the middle of each cell of the table that hair can reach",
                  worst, 8e-3);
}

TEST(Rod, TableHasTheSameBitsOnEveryMachine) {
    uint hash = 0;
    for (uint i = 0; i < kRodNodes * kRodNodes * kRodTexels; ++i)
        for (int k = 0; k < 4; ++k) hash = pcg(hash ^ std::bit_cast<uint>(rodTable()[i][k]));
    EXPECT_EQ(hash, 3382762110u);
}

TEST(Rod, IsAsLongAsAsked) {
    test::Draws draws(1);
    double worst = 0.0;
    for (int i = 0; i < 1500; ++i) {
        const Strand s =
            rodHair(glm::normalize(draws.inBox(1.0f)), glm::normalize(draws.inBox(1.0f)),
                    rodCoat(draws.in(0.0f, 1.0f), draws.in(0.0f, 1.0f)));
        double length = 0.0;
        glm::dvec2 before(0.0);
        for (int k = 1; k <= 4000; ++k) {
            const glm::dvec2 p(strandWeights(s, static_cast<float>(k) / 4000.0f));
            length += glm::distance(before, p);
            before = p;
        }
        worst = std::max(worst, std::abs(length * static_cast<double>(s.scale) - 1.0));
    }
    test::reached("H5", "length of rods, relative, any direction and softness", worst, 1e-5);
}

// Van Gelder and Wilhelms' rule is a first-order model of the rod.
TEST(Rod, ThePapersRuleHangsLikeTheRodOfItsLoad) {
    for (const auto& [load, meanBound, mostBound] : {std::tuple(0.5, 0.025, 0.035),
                                                     {1.0, 0.025, 0.035},
                                                     {3.0, 0.025, 0.035},
                                                     {5.0, 0.04, 0.065}}) {
        double sum = 0.0, most = 0.0;
        for (int degrees = 5; degrees < 180; degrees += 5) {
            const double error = paperShapeError(degrees * kDegree, load);
            sum += error / 35.0;
            most = std::max(most, error);
        }
        char what[100];
        std::snprintf(what, sizeof what, "the paper's rule against the rod of load %g: mean", load);
        test::reached("H7", what, sum, meanBound);
        test::reached("H7", "the same, at worst from 5 to 175 degrees", most, mostBound);
    }
}

TEST(Rod, MovesWithoutJumpsWhereverItPoints) {
    double worst = 0.0, azimuth = 0.0;
    for (const float load : {1.0f, 5.0f, 7.837f, 10.0f, 20.0f - 1e-3f, 20.0f + 1e-3f}) {
        for (const vec3 n : {vec3(0, 1, 0), vec3(0, -1, 0), vec3(1, 0, 0)})
            for (const double turn : {0.0, 1.0, 2.5}) {
                // Through up, along the skin and through down: a whole circle.
                for (int i = 0; i < 3600; ++i) {
                    const vec3 a = directionAt(0.1 * i * kDegree, turn);
                    const vec3 b = directionAt(0.1 * (i + 1) * kDegree, turn);
                    if (glm::dot(a, n) < 0.02f || glm::dot(b, n) < 0.02f) continue;
                    worst = std::max(worst, farthest(rodHair(n, a, load), rodHair(n, b, load)));
                }
                for (const double sign : {0.0, kPi}) {
                    const vec3 a = directionAt(sign + 1e-5, turn),
                               b = directionAt(sign - 1e-5, turn);
                    if (glm::dot(a, n) < 0.02f) continue;
                    azimuth = std::max(azimuth, farthest(rodHair(n, a, load), rodHair(n, b, load)));
                }
            }
    }
    using test::reached;
    reached("H9", "how far a turn of .1 degrees moves a rod of load 1 to 20", worst, 0.05);
    reached("H9", "the same where it passes through upright or straight down", azimuth, 1e-3);
}

TEST(Rod, SevenSegmentsAreNear) {
    double soft = 0.0, softest = 0.0;
    overRods(45, 40, [&](double root, double load, double faded) {
        const double error = chordDistance(curveOf(root, faded), 7u);
        softest = std::max(softest, error);
        if (load <= 20.0) soft = std::max(soft, error);
    });
    using test::reached;
    reached("H10", "7 chords of a rod against its curve, loads to 20", soft, 0.006);
    reached("H10", "the same, loads to 1000 (.006 was asked)", softest, 0.007);
}

TEST(Rod, TakesAsManySegmentsAsTheToleranceAsks) {
    test::Draws draws(3);
    double worst = 0.0, segments = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const Strand s =
            rodHair(vec3(0, 0, 1), glm::normalize(draws.inBox(1.0f) + vec3(0, 0, 1.1f)),
                    std::pow(10.0f, draws.in(-1.0f, 3.0f)));
        const double pixels = std::pow(10.0, draws.in(1.0f, 3.0f));
        const double tolerance = draws.in(0.25f, 0.5f) / pixels;
        const uint n = segmentsFor(s, static_cast<float>(tolerance));
        segments += n / 4000.0;
        if (n < 32)
            worst =
                std::max(worst, chordDistance(s.rod, n) * static_cast<double>(s.scale) / tolerance);
    }
    std::printf("%.1f segments\n", segments);
    test::reached("H11", "chords of rods 10 to 1000 pixels long, in tolerances of .25 to .5 pixels",
                  worst, 1.1);
}

TEST(Rod, TangentsAreThoseOfTheExactRod) {
    double soft = 0.0, softer = 0.0;
    overRods(45, 40, [&](double root, double load, double faded) {
        if (load > 20.0) return;
        const mat3x4 curve = curveOf(root, faded);
        const Rod rod = hangingRod(root, faded, 512);
        double length = 0.0;
        glm::dvec2 before(0.0);
        std::vector<double> lengths{0.0};
        for (int i = 1; i <= 700; ++i) {
            const glm::dvec2 p(rodWeights(curve, static_cast<float>(i) / 700.0f));
            lengths.push_back(length += glm::distance(p, before));
            before = p;
        }
        for (int i = 0; i <= 7; ++i) {
            const glm::dvec2 slope(rodSlope(curve, static_cast<float>(i) / 7.0f));
            const double s = 512.0 * lengths[static_cast<std::size_t>(i * 100)] / length;
            const auto k = static_cast<std::size_t>(std::min(s, 511.0));
            const double exact =
                glm::mix(rod.angle[k], rod.angle[k + 1], s - static_cast<double>(k));
            const double error = std::abs(root + std::atan2(slope.y, slope.x) - exact) / kDegree;
            double& worst = load <= 8.0 ? soft : softer;
            worst = std::max(worst, error);
        }
    });
    using test::reached;
    reached("H12", "tangents (degrees) at the ends of 7 segments of a rod, loads to 8", soft, 1.5);
    reached("H12", "the same, loads to 20", softer, 3.0);
}

TEST(Rod, IsStraightWithoutWeight) {
    const vec3 w = glm::normalize(vec3(1, 2, 3));
    const Strand s = bendStrand(vec3(0), vec3(0, 1, 0), w, 0.1f, rodCoat(0.0f, 1.0f), 1u, vec3(0));
    for (const float t : {0.2f, 0.7f, 1.0f}) {
        EXPECT_LT(glm::distance(strandTangent(s, t), w), 1e-6f);
        EXPECT_LT(glm::length(glm::cross(strandPoint(s, t), w)), 1e-7f);
    }
    EXPECT_LT(glm::distance(strandPoint(s, 1.0f), 0.1f * w), 1e-6f);
}

TEST(Rod, LeavesTheSkinTowardsItsDirectionAndIsDrawnStraightAsALine) {
    Coat coat = rodCoat(0.2f, 0.4f);
    const vec3 n(0, 1, 0), w = glm::normalize(vec3(1, 1, 0));
    const Strand curve = rodHair(n, w, coat);
    EXPECT_LT(glm::distance(strandTangent(curve, 0.0f), w), 1e-6f);
    coat.style = kStyleLine;
    const Strand line = rodHair(n, w, coat);
    const vec3 tip = strandPoint(line, 1.0f);
    EXPECT_NEAR(glm::length(tip), 1.0f, 1e-5f);
    EXPECT_LT(glm::distance(tip, glm::normalize(strandPoint(curve, 1.0f))), 1e-4f);
    EXPECT_LT(glm::distance(strandPoint(line, 0.5f), 0.5f * tip), 1e-6f);
}

TEST(Rod, HangsLowerTheSofterItIs) {
    const vec3 n(0, -0.6f, 0.8f), w = glm::normalize(vec3(0.3f, 0.2f, 1.0f));
    float before = 2.0f;
    for (int i = 0; i <= 20; ++i) {
        const float x = static_cast<float>(i) / 10.0f;
        const float tip =
            strandPoint(rodHair(n, w, rodCoat(std::max(0.0f, 1.0f - x), std::max(0.0f, x - 1.0f))),
                        1.0f)
                .y;
        EXPECT_LT(tip, before + 1e-4f) << x;
        before = tip;
    }
    EXPECT_LT(before, -0.85f);
}

}  // namespace
}  // namespace pelage
