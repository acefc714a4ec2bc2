// coats_hardtest.cpp -- every parameter at its ends, alone, in pairs and all together.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/coat.h"
#include "hair_check.h"
#include "hard_cases.h"

namespace pelage {
namespace {

using test::Worst;

// A ball with an even groom of ordinary hair, or with a drawn one.
Document furryBall(const Fur& fur, test::Draws* draws = nullptr) {
    static const auto skin = makeSkin(test::ball(3));
    Document document{skin, {}, fur};
    document.groom = draws ? test::drawnGroom(*skin, skin->size(), *draws) : test::evenGroom(*skin);
    return document;
}

TEST(HardCoats, EveryParameterAtBothEnds) {
    Worst worst;
    test::Draws draws(1);
    const auto tryBoth = [&](const Parameter& row, auto set) {
        for (const float end : {row.least, row.greatest}) {
            Fur fur = defaultFur();
            fur.over.clump = fur.over.curlRadius = fur.under.frizz = fur.wind = 0.3f;
            fur.over.curlTurns = 3.0f;
            set(fur, end);
            fur.hairs = std::min(fur.hairs, 2000u);
            ASSERT_EQ(test::faultOf(furryBall(fur, &draws), worst), "") << row.name << " = " << end;
        }
    };
    for (const Parameter& row : coatParameters())
        tryBoth(row, [&](Fur& fur, float end) {
            setParameter(fur.over, row, vec3(end));
            setParameter(fur.under, row, vec3(end));
        });
    for (const Parameter& row : furParameters())
        tryBoth(row, [&](Fur& fur, float end) { setParameter(fur, row, vec3(end)); });
    test::print(worst);
}

TEST(HardCoats, AllParametersTogetherAMillionHairs) {
    Worst worst;
    test::Draws draws(2);
    while (worst.hairs < 1'000'000) {
        Fur fur = test::drawnFur(draws);
        fur.hairs = 5000;
        ASSERT_EQ(test::faultOf(furryBall(fur, &draws), worst), "") << furToJson(fur);
    }
    test::print(worst);
    EXPECT_GT(worst.clumped, 300'000u);
}

TEST(HardCoats, EachPairOfModifiersAtFullStrength) {
    Worst worst;
    const auto clump = [](Fur& fur) { fur.over.clump = fur.under.clump = 1.0f; };
    const auto curl = [](Fur& fur) {
        fur.over.curlRadius = fur.under.curlRadius = 0.5f;
        fur.over.curlTurns = fur.under.curlTurns = 20.0f;
    };
    const auto frizz = [](Fur& fur) {
        fur.over.frizz = fur.under.frizz = 0.5f;
        fur.over.frizzWaves = fur.under.frizzWaves = 16.0f;
    };
    const auto wind = [](Fur& fur) { fur.wind = fur.gusts = 1.0f; };
    for (uint pair = 0; pair < 16; ++pair) {  // all sets, the pairs among them
        for (uint style = kStyleLine; style <= kStyleTube; ++style)
            for (const float stiffness : {0.0f, 1.0f}) {
                Fur fur = defaultFur();
                fur.hairs = 2000;
                for (Coat* coat : {&fur.over, &fur.under}) {
                    coat->style = style;
                    coat->stiffness = stiffness;
                    coat->clumpShape = 0.5f + 3.5f * stiffness;
                }
                if (pair & 1u) clump(fur);
                if (pair & 2u) curl(fur);
                if (pair & 4u) frizz(fur);
                if (pair & 8u) wind(fur);
                ASSERT_EQ(test::faultOf(furryBall(fur), worst), "")
                    << "set " << pair << ", style " << style << ", stiffness " << stiffness;
            }
    }
    test::print(worst);
}

}  // namespace
}  // namespace pelage
