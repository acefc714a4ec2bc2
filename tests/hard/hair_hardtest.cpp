// hair_hardtest.cpp -- the shape of single hairs where its formulas divide by nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/coat.h"
#include "hair_check.h"
#include "hard_cases.h"
#include "tests/figures.h"

namespace pelage {
namespace {

using test::Worst;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
const vec3 kUp(0, 1, 0), kDown(0, -1, 0);

// A triangle of which all corners have one normal, at `place`, and a root in its middle.
struct Patch {
    SkinVertex a{}, b{}, c{};
    Root root{0, 20000u | 20000u << 16, 77, 0};

    explicit Patch(vec3 n, vec3 place = vec3(0)) {
        const vec3 x = anyTangent(n), y = glm::cross(n, x);
        a.position = place;
        b.position = place + x;
        c.position = place + y;
        a.normal = b.normal = c.normal = n;
    }
    Strand grow(const FurVertex& painted, const Fur& fur) const {
        return growStrand(root, a, b, c, painted, painted, painted, fur, 1e-4f, 0.5f);
    }
};

// Directions about n where the rule of droop, its mirror and its tie-break change over.
std::vector<vec3> directionsAbout(vec3 n) {
    const vec3 t = anyTangent(n);
    std::vector<vec3> all{vec3(0), n,        -n,       kUp,       kDown,    t,
                          -t,      0.5f * n, 2.0f * n, -0.5f * n, 1e20f * n};
    for (const float tiny : {1e-3f, 1e-7f, 1e-20f, 1e-38f, 1e-45f}) {
        all.insert(all.end(), {n + tiny * t, -n + tiny * t, t + tiny * n, t - tiny * n, tiny * t});
    }
    for (const float odd : {kNan, kInf, -kInf, 1e20f, -0.0f})
        all.insert(all.end(), {vec3(odd, 0.5f, 0.1f), vec3(0.1f, odd, 0.5f), vec3(0.5f, 0.1f, odd),
                               vec3(odd)});
    return all;
}

TEST(HardHair, EveryDirectionStiffnessPullAndLength) {
    Worst worst;
    for (const vec3 n : {kUp, kDown, vec3(1, 0, 0), vec3(0, 0, -1), glm::normalize(vec3(1, 1, 1)),
                         glm::normalize(vec3(1e-7f, 1, 0)), glm::normalize(vec3(1e-4f, -1, 1e-4f))})
        for (const vec3 direction : directionsAbout(n))
            for (const float stiffness : {0.0f, 0.02f, 0.98f, 1.0f, -1.0f, 2.0f, kNan})
                for (const float weight : {0.0f, 0.5f, 1.0f, kNan})
                    for (const float randomness : {0.0f, 1.0f})
                        for (const uint droop : {kDroopPaper, kDroopElastica})
                            for (const float furLength : {1e-12f, 1e-6f, 0.04f, 1e6f}) {
                                Fur fur = defaultFur();
                                fur.wind = randomness;
                                fur.over.stiffness = fur.under.stiffness = stiffness;
                                fur.over.directionWeight = fur.under.directionWeight = weight;
                                fur.over.endRandomness = fur.under.endRandomness = randomness;
                                fur.over.curlRadius = 0.5f;
                                fur.over.curlTurns = 2.0f;
                                fur.over.droop = fur.under.droop = droop;
                                fur.over.softness = fur.under.softness = 0.7f * randomness;
                                const Strand s =
                                    Patch(n).grow({direction, furLength, vec3(1), 1.0f}, fur);
                                const Coat& coat = s.coat == 0 ? fur.over : fur.under;
                                ASSERT_EQ(test::faultOf(s, coat, worst), "")
                                    << "n " << n.x << "," << n.y << "," << n.z << " direction "
                                    << direction.x << "," << direction.y << "," << direction.z
                                    << " stiffness " << stiffness << " weight " << weight
                                    << " randomness " << randomness << " length " << furLength;
                            }
    test::print(worst);
}

TEST(HardHair, LengthsThatAreNoneGrowNothing) {
    for (const float none : {0.0f, -0.0f, -1.0f, 1e-45f, 1e-13f, 1.1e6f, 1e20f, kInf, -kInf, kNan})
        EXPECT_EQ(Patch(kUp).grow({kUp, none, vec3(1), 1.0f}, defaultFur()).spineLength, 0.0f);
}

// Numbers that no file may hold, since reading checks ranges; strand.glsl promises to stand them.
TEST(HardHair, EveryFieldOfACoatMayBeAnything) {
    for (const Parameter& row : coatParameters())
        for (const Parameter& other : coatParameters()) {
            if (row.kind != ParameterKind::scalar || other.kind != ParameterKind::scalar) continue;
            for (const float odd : {kNan, kInf, -kInf, -1.0f, 1e20f, -1e20f, 1e-45f}) {
                Fur fur = defaultFur();
                for (Coat* coat : {&fur.over, &fur.under}) {
                    coat->clump = coat->curlRadius = coat->frizz = 0.4f;
                    coat->curlTurns = 3.0f;
                    for (const Parameter* field : {&row, &other})
                        *reinterpret_cast<float*>(reinterpret_cast<char*>(coat) + field->offset) =
                            odd;
                }
                const FurVertex painted{vec3(0.3f, 0.2f, 0.1f), 0.04f, vec3(1), 1.0f};
                const Strand guide = Patch(kUp, vec3(0.1f)).grow(painted, fur);
                const Strand spine = Patch(kUp).grow(painted, fur);
                const Strand s = gatherStrand(spine, guide, fur.over);
                EXPECT_TRUE(std::isfinite(s.width) && std::isfinite(s.tone)) << row.name;
                for (const float t : {0.0f, 0.3f, 1.0f}) {
                    const vec3 p = strandPoint(s, t), along = strandTangent(s, t);
                    const vec3 normal = strandNormal(s, along);
                    EXPECT_TRUE(std::isfinite(glm::dot(p, p) + glm::dot(along, along) +
                                              glm::dot(normal, normal)))
                        << row.name << " and " << other.name << " = " << odd << " at " << t;
                }
            }
        }
}

// As a comb of nothing turns about a hair that stands straight up, the hair stays where it is.
TEST(HardHair, NothingTurnsAboutUpright) {
    for (const float stiffness : {0.0f, 0.02f, 0.5f})
        for (const float sign : {1.0f, -1.0f}) {
            Fur fur = defaultFur();
            fur.over.stiffness = fur.under.stiffness = stiffness;
            fur.over.endRandomness = fur.under.endRandomness = 0.0f;
            vec3 first(0);
            for (int i = 0; i <= 360; ++i) {
                const float turn = 0.017453293f * static_cast<float>(i);
                const vec3 direction(1e-7f * std::cos(turn), sign, 1e-7f * std::sin(turn));
                const Strand s = Patch(sign * kUp).grow({direction, 1.0f, vec3(1), 1.0f}, fur);
                const vec3 tip = s.spineLength > 0.0f
                                     ? (strandPoint(s, 1.0f) - s.origin) / s.spineLength
                                     : vec3(0);
                if (i == 0) first = tip;
                ASSERT_LT(glm::distance(tip, first), 1e-4f) << stiffness << ", " << i;
            }
        }
}

// Paper mode: the end moves at most 1.01 / (1 - floppiness) times as far as the weightless
// direction, beside what the tie-break follows the comb by (its own 0.02, amplified likewise).
TEST(HardHair, EndsFollowTheDirectionWithoutJumps) {
    test::Draws draws(5);
    float worst = 0.0f;
    for (int i = 0; i < 100'000; ++i) {
        const vec3 n = safeUnit(draws.inBox(1.0f), kUp);
        const float stiffness = draws.in(0.02f, 1.0f);
        Fur fur = defaultFur();
        fur.under.stiffness = stiffness;
        fur.share = 0.0f;
        fur.under.endRandomness = 0.0f;
        const vec3 d = draws.inBox(1.0f), e = d + draws.inBox(1e-3f);
        const vec3 flatD = d - glm::dot(d, n) * n, flatE = e - glm::dot(e, n) * n;
        if (glm::length(flatD) < 0.05f || glm::length(flatE) < 0.05f) continue;
        const Strand s = Patch(n).grow({d, 1.0f, vec3(1), 1.0f}, fur);
        const Strand u = Patch(n).grow({e, 1.0f, vec3(1), 1.0f}, fur);
        if (glm::dot(s.weightless, n) < 0.01f) continue;  // the mirror has a kink
        const float moved = glm::distance(s.weightless, u.weightless);
        const float comb = 0.02f * glm::distance(glm::normalize(flatD), glm::normalize(flatE));
        const float floppiness = std::max(1.0f - stiffness, 0.02f);
        worst = std::max(
            worst, (glm::distance(s.end, u.end) - 3e-6f) * (1.0f - floppiness) / (moved + comb));
    }
    test::reached("H9", "paper: move of the end times stiffness, over that of the direction", worst,
                  1.01);
}

// A curled hair that stands straight is as long as asked within 1e-4. About a bent spine the curl
// is longer on the outer side, and hair lifted onto the skin is shorter: within a fifth.
TEST(HardHair, CurledHairIsAsLongAsAsked) {
    test::Draws draws(6);
    for (int i = 0; i < 3000; ++i) {
        const bool straight = i % 2 == 0;
        Fur fur = defaultFur();
        fur.share = 0.0f;
        fur.gravity = straight ? 0.0f : 1.0f;
        fur.under.endRandomness = straight ? 0.0f : 1.0f;
        fur.under.directionWeight = straight ? 0.0f : draws.in(0.0f, 1.0f);
        fur.under.stiffness = draws.in(0.0f, 1.0f);
        fur.under.curlRadius = draws.in(0.0f, 0.5f);
        fur.under.curlTurns = draws.in(0.0f, 20.0f);
        Patch patch(safeUnit(draws.inBox(1.0f), kUp));
        patch.root.id = pcg(static_cast<uint>(i));
        const Strand s = patch.grow({draws.inBox(1.0f), 0.04f, vec3(1), 1.0f}, fur);
        const double coarse = test::chordLength(s, 1000), fine = test::chordLength(s, 2000);
        const double found = fine + (fine - coarse) / 3.0;
        EXPECT_NEAR(found / s.spineLength, 1.0, straight ? 1e-4 : 0.2) << i;
    }
}

TEST(HardHair, TheCheckSeesEachFault) {
    const Fur fur = defaultFur();
    const Strand good = Patch(kUp).grow({vec3(1, 0, 0), 0.04f, vec3(1), 1.0f}, fur);
    const Coat& coat = good.coat == 0 ? fur.over : fur.under;
    const auto faultAfter = [&](auto spoil) {
        Strand s = good;
        spoil(s);
        Worst worst;
        return test::faultOf(s, coat, worst);
    };
    EXPECT_EQ(faultAfter([](Strand&) {}), "");
    const std::pair<std::string, std::string> expected[] = {
        {"its spine", faultAfter([](Strand& s) { s.spineLength *= 1.00002f; })},
        {"starts off", faultAfter([](Strand& s) { s.scale = kNan; })},
        {"skin normal", faultAfter([](Strand& s) { s.normal *= 1.0001f; })},
        {"under the skin", faultAfter([](Strand& s) { s.end.y = -1e-4f; })},
        {"out of reach", faultAfter([](Strand& s) { s.weightless *= 30.0f; })},
        {"width", faultAfter([](Strand& s) { s.width = kNan; })},
        {"density", faultAfter([](Strand& s) { s.keep = 2.0f; })},
        {"not unit", faultAfter([](Strand& s) { s.style = kStylePolyline, s.cosTwist = 2.0f; })},
    };
    for (const auto& [wanted, found] : expected)
        EXPECT_NE(found.find(wanted), std::string::npos) << wanted << ": " << found;
}

}  // namespace
}  // namespace pelage
