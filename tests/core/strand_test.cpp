// strand_test.cpp -- the promises of shaders/strand.glsl and shaders/fiber.glsl, run as C++.
#include "core/strand.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "core/coat.h"
#include "tests/figures.h"

namespace pelage {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
const vec3 kUp(0, 1, 0), kDown(0, -1, 0);

bool finite(vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// A stream of test values from a counter.
struct Stream {
    uint n;
    float next() { return rand01(pcg(n++)); }
    float range(float a, float b) { return a + (b - a) * next(); }
    vec3 direction() { return safeUnit(vec3(range(-1, 1), range(-1, 1), range(-1, 1)), kUp); }
};

Coat coatWith(float stiffness, float weight, float endRandomness) {
    Coat coat = defaultFur().over;
    coat.stiffness = stiffness;
    coat.directionWeight = weight;
    coat.endRandomness = endRandomness;
    return coat;
}

// Sum of many short chords.
double arcLength(const Strand& s) {
    double sum = 0.0;
    glm::dvec3 before = s.origin;
    for (int i = 1; i <= 4000; ++i) {
        const glm::dvec3 p = strandPoint(s, static_cast<float>(i) / 4000.0f);
        sum += glm::distance(before, p);
        before = p;
    }
    return sum;
}

TEST(Strand, ArcPolynomialIsWithinThreeMillionthsOfTheClosedForm) {
    double worst = 0.0;
    for (int i = 1; i <= 1020; ++i) {
        const double m = i * 1e-3, a = 1 - m / 2, b = 8 * m;
        const auto f = [&](double x) {
            return 0.5 * (x * std::sqrt(a + b * x * x) +
                          a / std::sqrt(b) * std::asinh(x * std::sqrt(b / a)));
        };
        const double exact = f(0.75) - f(-0.25);
        worst = std::max(worst, std::abs(arcOfUnitCurve(static_cast<float>(m)) - exact) / exact);
    }
    EXPECT_LT(worst, 3.5e-6);
}

TEST(Strand, IsAsLongAsAsked) {
    Stream random{1};
    double worst = 0.0;
    for (int i = 0; i < 300; ++i) {
        const Coat coat = coatWith(random.next(), random.next(), 0.5f * random.next());
        const Strand s = bendStrand(vec3(0), random.direction(), random.direction(), 0.04f, coat,
                                    pcg(static_cast<uint>(i)), kDown);
        worst = std::max(worst, std::abs(arcLength(s) / 0.04 - 1.0));
    }
    test::reached("H5", "length of curves of the paper's rule, relative", worst, 1e-5);
}

// What the paper leaves open is the pull of 0.02 g to the combed side and the length.
TEST(Strand, IsTheCurveOfThePapersControlPoints) {
    Stream random{11};
    double worst = 0.0;
    int hairs = 0;
    while (hairs < 20000) {
        const glm::dvec3 n(random.direction()), d(random.direction()), up(kUp);
        const float stiffness = random.range(0.0f, 0.98f), weight = random.next();
        const glm::dvec3 w = glm::normalize((1.0 - weight) * n + static_cast<double>(weight) * d);
        const double g = (1.0 - static_cast<double>(stiffness)) * glm::dot(w, n);
        const glm::dvec3 side = d - glm::dot(d, n) * n;
        if (g < 0.0 || glm::length(side) < 0.1 || glm::length(w - g * up) < 0.1) continue;
        ++hairs;
        const glm::dvec3 e = glm::normalize(w + g * (0.02 * glm::normalize(side) - up));
        const Strand s = bendStrand(vec3(0), vec3(n), vec3(d), 1.0f,
                                    coatWith(stiffness, weight, 0.0f), 5u, kDown);
        for (const double t : {0.25, 0.5, 0.75, 1.0}) {
            // Bernstein's polynomials on 0, w/3, (w + E)/3, E.
            const double u = 1.0 - t;
            const glm::dvec3 p = u * u * t * w + u * t * t * (w + e) + t * t * t * e;
            const glm::dvec3 q(strandPoint(s, static_cast<float>(t)));
            worst = std::max(worst, glm::distance(q / static_cast<double>(s.scale), p));
        }
    }
    test::reached("H6", "curves against the paper's formula in double precision, 20,000 at random",
                  worst, 2e-6);
}

// The greatest distance of the curve from its chord, of seven.
double chordDistance(const Strand& s) {
    double worst = 0.0;
    for (int i = 0; i < 7; ++i) {
        const glm::dvec3 a(strandPoint(s, static_cast<float>(i) / 7.0f));
        const glm::dvec3 b(strandPoint(s, static_cast<float>(i + 1) / 7.0f));
        for (int k = 1; k < 16; ++k) {
            const auto t = (static_cast<float>(i) + static_cast<float>(k) / 16.0f) / 7.0f;
            const glm::dvec3 p = glm::dvec3(strandPoint(s, t)) - a, along = glm::normalize(b - a);
            worst = std::max(worst, glm::length(p - glm::dot(p, along) * along));
        }
    }
    return worst;
}

TEST(Strand, SevenSegmentsAreNear) {
    double nearlyLimp = 0.0, limp = 0.0;
    for (int i = 1; i < 720; ++i) {
        const double angle = 0.25 * i / 57.29578;
        const vec3 n(std::sin(angle), std::cos(angle), 0.0f);
        const auto hair = [&](float stiffness) {
            return bendStrand(vec3(0), n, vec3(0, 0, 1), 1.0f, coatWith(stiffness, 0.0f, 0.0f), 1u,
                              kDown);
        };
        nearlyLimp = std::max(nearlyLimp, chordDistance(hair(0.02f)));
        limp = std::max(limp, chordDistance(hair(0.0f)));
    }
    using test::reached;
    reached("H10", "7 chords of a curve of the paper's rule, floppiness .98", nearlyLimp, 0.0065);
    reached("H10", "the same, floppiness 1", limp, 0.0073);
}

TEST(Strand, FollowsThePapersRuleAwayFromItsSingularities) {
    // The literal rule of section 3.5: E = normalise(w - f cos(theta) up), chord of length 1, with
    // the template (1/3, 2/3, 1); compared before arc normalisation, up to the tie-break of 0.02 g.
    Stream random{7};
    for (int i = 0; i < 2000; ++i) {
        const vec3 n = random.direction(), d = random.direction();
        const float stiffness = random.range(0.0f, 0.98f), weight = random.next();
        const vec3 w = glm::normalize((1 - weight) * n + weight * d);
        const float c = glm::dot(w, n);
        const vec3 literal = w - (1 - stiffness) * c * kUp;
        if (!(c > 0.05f) || glm::length(literal) < 0.1f) continue;
        const Strand s =
            bendStrand(vec3(0), n, d, 1.0f, coatWith(stiffness, weight, 0.0f), 5u, kDown);
        EXPECT_LT(glm::distance(s.weightless, w), 2e-6f);
        const float tieBreak = 0.02f * (1 - stiffness) * c / glm::length(literal);
        EXPECT_LT(glm::distance(s.end, glm::normalize(literal)), 1.01f * tieBreak + 2e-6f);
    }
}

TEST(Strand, HorizontalHairsDroopAtMostToFortyFiveDegrees) {
    const Strand s =
        bendStrand(vec3(0), vec3(1, 0, 0), vec3(1, 0, 0), 1.0f, coatWith(0, 0, 0), 1u, kDown);
    EXPECT_NEAR(std::atan2(-s.end.y, s.end.x), 0.7854f, 0.02f);
}

TEST(Strand, StartsOnTheSkinTowardsTheWeightlessDirection) {
    const Strand s =
        bendStrand(vec3(1, 2, 3), kUp, vec3(1, 0, 0), 0.1f, coatWith(0.2f, 0.5f, 0), 9u, kDown);
    EXPECT_EQ(strandPoint(s, 0.0f), vec3(1, 2, 3));
    EXPECT_NEAR(glm::dot(strandTangent(s, 0.0f), s.weightless), 1.0f, 1e-6f);
}

// Inputs of the hard cases: every value at both ends, wrong signs, denormals, infinities, NaN.
std::vector<float> hardNumbers() {
    return {0.0f, -0.0f, 1e-45f, 1e-38f, 1e-20f, 0.02f, 0.5f, 0.98f,
            1.0f, -1.0f, 2.0f,   1e20f,  kInf,   -kInf, kNan};
}

TEST(Strand, EveryInputGivesAFiniteHairAboveItsRootPlane) {
    const std::vector<float> numbers = hardNumbers();
    const auto pick = [&](uint h) { return numbers[h % numbers.size()]; };
    std::size_t hairs = 0;
    for (uint i = 0; i < 400000; ++i) {
        uint h = pcg(i);
        const auto next = [&] { return h = pcg(h); };
        const vec3 n = safeUnit(vec3(pick(next()), pick(next()), pick(next())), kUp);
        const vec3 painted(pick(next()), pick(next()), pick(next()));
        Coat coat = coatWith(pick(next()), pick(next()), pick(next()));
        Fur fur = defaultFur();
        fur.gravity = pick(next());
        fur.wind = pick(next());
        fur.gusts = pick(next());
        const vec3 pull = pullAt(fur, vec3(pick(next())), pick(next()));
        const Strand s = bendStrand(vec3(0), n, painted, 1.0f, coat, next(), pull);
        for (int p = 0; p <= 7; ++p) {
            const float t = static_cast<float>(p) / 7.0f;
            const vec3 point = strandPoint(s, t);
            ASSERT_TRUE(finite(point)) << "case " << i;
            ASSERT_GT(glm::dot(point, n), -2e-5f) << "case " << i << ": under the skin";
            const vec3 tangent = strandTangent(s, t);
            ASSERT_NEAR(glm::length(tangent), 1.0f, 1e-4f) << "case " << i;
            ASSERT_TRUE(finite(strandNormal(s, tangent))) << "case " << i;
        }
        ++hairs;
    }
    EXPECT_EQ(hairs, 400000u);
}

TEST(Strand, ALengthThatIsNoneGivesNoHair) {
    SkinVertex a{}, b{}, c{};
    b.position = vec3(1, 0, 0);
    c.position = vec3(0, 0, 1);
    a.normal = b.normal = c.normal = kUp;
    for (const float furLength : {0.0f, -1.0f, 1e-13f, 1e-45f, 2e6f, kInf, kNan}) {
        FurVertex fur{};
        fur.furLength = furLength;
        fur.density = 1.0f;
        const Strand s =
            growStrand(Root{0, 0, 1, 0}, a, b, c, fur, fur, fur, defaultFur(), 1e-4f, 0.0f);
        EXPECT_EQ(s.spineLength, 0.0f) << furLength;
        EXPECT_TRUE(finite(strandPoint(s, 1.0f))) << furLength;
    }
}

TEST(Strand, DensityThatIsNoneKeepsNoHair) {
    SkinVertex a{}, b{}, c{};
    a.normal = b.normal = c.normal = kUp;
    for (const float density : {0.0f, -3.0f, kNan}) {
        FurVertex fur{};
        fur.furLength = 1.0f;
        fur.density = density;
        const Strand s =
            growStrand(Root{0, 0, 1, 0}, a, b, c, fur, fur, fur, defaultFur(), 1e-4f, 0.0f);
        EXPECT_EQ(s.keep, 0.0f) << density;
    }
}

TEST(Strand, NormalsThatCancelFallBackToTheFace) {
    SkinVertex a{}, b{}, c{};
    b.position = vec3(0, 0, 1);
    c.position = vec3(1, 0, 0);
    a.normal = kUp;
    b.normal = kDown;
    FurVertex fur{};
    fur.furLength = 1.0f;
    const Root middle{0, 32767u | 32767u << 16u, 1, 0};
    const Strand s = growStrand(middle, a, b, c, fur, fur, fur, defaultFur(), 1e-4f, 0.0f);
    EXPECT_NEAR(s.normal.y, 1.0f, 1e-5f);
}

TEST(Strand, ShadingNormalIsPerpendicularInThePlaneAndOnTheConvexSide) {
    Coat coat = coatWith(0.2f, 0.0f, 0.0f);
    coat.normalRandomness = 0.0f;
    const Strand s = bendStrand(vec3(0), vec3(1, 0, 0), vec3(0), 1.0f, coat, 1u, kDown);
    for (const float t : {0.0f, 0.5f, 1.0f}) {
        const vec3 tangent = strandTangent(s, t), normal = strandNormal(s, tangent);
        EXPECT_NEAR(glm::dot(tangent, normal), 0.0f, 1e-6f);
        EXPECT_NEAR(normal.z, 0.0f, 0.021f) << "outside the plane of the hair and its tie-break";
        EXPECT_GT(normal.y, 0.2f) << "on the inner side of the bend";
    }
}

TEST(Strand, EndRandomnessTurnsByTheRootMeanSquareOfTheMethod) {
    const double expected[][2] = {{0.1, 3.6}, {0.2, 7.3}, {0.5, 18.0}, {1.0, 37.0}};
    for (const auto& [amount, degrees] : expected) {
        double sum = 0.0;
        const int count = 40000;
        for (int i = 0; i < count; ++i) {
            const Strand s = bendStrand(vec3(0), kUp, vec3(0), 1.0f,
                                        coatWith(1.0f, 0.0f, static_cast<float>(amount)),
                                        hairId(static_cast<uint>(i), 0, 1), vec3(0));
            const double angle = std::acos(std::min(1.0f, glm::dot(s.weightless, kUp)));
            sum += angle * angle;
        }
        EXPECT_NEAR(std::sqrt(sum / count) * 57.29578, degrees, 0.03 * degrees + 0.1) << amount;
    }
}

TEST(Strand, RandomBallIsUniformInsideTheUnitBall) {
    double sum[3] = {0, 0, 0}, square = 0;
    const int count = 100000;
    for (int i = 0; i < count; ++i) {
        const vec3 p = randomInBall(hairId(static_cast<uint>(i), 3, 1));
        EXPECT_LE(glm::length(p), 1.000001f);
        for (int c = 0; c < 3; ++c) sum[c] += p[c];
        square += glm::dot(p, p);
    }
    for (const double s : sum) EXPECT_NEAR(s / count, 0.0, 0.01);
    EXPECT_NEAR(square / count, 0.6, 0.005);
}

TEST(Fiber, SineIsExactForNearlyParallelVectors) {
    const vec3 t = glm::normalize(vec3(1, 2, 3));
    EXPECT_EQ(sineBetween(t, t), 0.0f);
    const vec3 side = anyTangent(t);
    const double exact = std::sin(std::atan(1e-3));
    test::reached("S1", "sine between hair and light 1 mrad apart, relative",
                  std::abs(sineBetween(t, glm::normalize(t + 1e-3f * side)) / exact - 1.0), 1e-3);
}

// Along x but for a thousandth, over skin that faces up; so does its shading normal.
Strand horizontalHair() {
    Coat straight = coatWith(1.0f, 1.0f, 0.0f);
    straight.normalRandomness = 0.0f;
    const vec3 painted(0.999f, 0.001f, 0);
    return bendStrand(vec3(0), vec3(0, 1, 0), painted, 1.0f, straight, 1u, vec3(0));
}

TEST(Fiber, HighlightPeaksWhereTheMirrorWouldBe) {
    // Light 30 degrees off the normal plane of the hair: the cone of reflection lies at -30
    // degrees, not at +30 (the sign trap of the commonly printed formula).
    const Strand s = horizontalHair();
    Coat coat = coatWith(1.0f, 0.0f, 0.0f);
    coat.ambient = coat.diffuse = vec3(0);
    coat.specular = vec3(1);
    coat.shininess = 50.0f;
    double worst = 0.0;
    for (const double inclination : {0.0, 30.0, 60.0, 85.0}) {
        Light light{};
        const double i = inclination / 57.29578;
        light.toKey = vec3(std::sin(i), std::cos(i), 0);
        light.key = 1.0f;
        double best = 0.0, at = 0.0;
        for (int o = -890; o <= 890; ++o) {
            const double a = o * 0.1 / 57.29578;
            const vec3 eye(std::sin(a), std::cos(a), 0);
            const double radiance = fiberRadiance(s, coat, light, vec3(1), 1.0f, eye, 0.0f).x;
            if (radiance > best) best = radiance, at = o * 0.1;
        }
        worst = std::max(worst, std::abs(at + inclination));
    }
    test::reached("S2", "highlight (degrees) off the mirror's direction, light at 0, 30, 60, 85",
                  worst, 0.5);
}

TEST(Fiber, MeanFacingIsTheMeanOverTheWidthOfARoundHair) {
    Stream random{5};
    constexpr int kSteps = 4000;
    for (int i = 0; i < 200; ++i) {
        const vec3 tangent = random.direction(), l = random.direction();
        const vec3 middle = safeUnit(cross(tangent, random.direction()), anyTangent(tangent));
        const vec3 right = cross(middle, tangent);
        double sum = 0.0;
        for (int k = 0; k < kSteps; ++k) {
            const float x = (static_cast<float>(k) + 0.5f) * (2.0f / kSteps) - 1.0f;
            const vec3 normal = x * right + std::sqrt(1.0f - x * x) * middle;
            sum += static_cast<double>(std::max(0.0f, dot(normal, l)));
        }
        EXPECT_NEAR(meanFacing(tangent, middle, l), sum / kSteps, 1e-4);
    }
    const vec3 along(1, 0, 0), up(0, 1, 0);
    EXPECT_NEAR(meanFacing(along, up, up), 0.25f * 3.1415927f, 1e-6f);
    EXPECT_NEAR(meanFacing(along, up, -up), 0.0f, 1e-6f);
    EXPECT_EQ(meanFacing(along, up, along), 0.0f);
}

TEST(Fiber, IsFiniteAndNotNegativeInEveryDirection) {
    Stream random{3};
    const Fur fur = defaultFur();
    for (int i = 0; i < 20000; ++i) {
        Strand s = bendStrand(vec3(0), random.direction(), random.direction(), 0.1f, fur.over,
                              pcg(static_cast<uint>(i)), kDown);
        s.style = static_cast<uint>(i % 5);
        Light light{};
        light.toKey = i % 7 == 0 ? strandTangent(s, 0.5f) : random.direction();
        light.key = 2.0f;
        light.sky = vec3(1);
        const vec3 eye = i % 5 == 0 ? light.toKey : random.direction();
        const vec3 color = (i % 2 ? fiberRadiance : roundRadiance)(
            s, fur.over, light, vec3(0.5f), random.next(), eye, 30.0f * random.next());
        ASSERT_TRUE(finite(color));
        ASSERT_GE(std::min({color.x, color.y, color.z}), 0.0f);
    }
}

TEST(Fiber, TheCoatIsDarkerTowardsTheRoot) {
    Fur fur = defaultFur();
    const float root = depthInCoat(fur, 1.75e6f, 0.01f, 5e-4f, 5e-4f, 0u, 0.0f);
    float before = root;
    for (int i = 1; i <= 10; ++i) {
        const float depth =
            depthInCoat(fur, 1.75e6f, 0.01f, 5e-4f, 5e-4f, 0u, static_cast<float>(i) * 0.1f);
        EXPECT_LE(depth, before);
        before = depth;
    }
    EXPECT_NEAR(before, 0.0f, 1e-6f) << "nothing stands above the tips";
    EXPECT_LT(skyThroughCoat(root), 0.7f);
    EXPECT_EQ(skyThroughCoat(0.0f), 1.0f);
}

TEST(Fiber, AnUndercoatTipLiesAsDeepAsTheOvercoatAtThatHeight) {
    Fur fur = defaultFur();
    fur.over.relativeLength = 1.0f;
    fur.under.relativeLength = 0.5f;
    EXPECT_NEAR(depthInCoat(fur, 1e6f, 0.02f, 3e-4f, 2e-4f, 1u, 1.0f),
                depthInCoat(fur, 1e6f, 0.02f, 3e-4f, 2e-4f, 0u, 0.5f), 1e-6f);
}

TEST(Hash, DrawsOfAHairDoNotRepeatTheirNeighbours) {
    EXPECT_NE(hairId(0, 0, 1) + 1u, hairId(0, 1, 1));
    EXPECT_NE(hairId(1, 0, 1), hairId(0, 1, 1));
    EXPECT_NE(hairId(0, 0, 1), hairId(0, 0, 2));
    EXPECT_LT(rand01(0xffffffffu), 1.0f);
}

}  // namespace
}  // namespace pelage
