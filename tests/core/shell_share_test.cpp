// shell_share_test.cpp -- where shells stand for strands.
#include "core/shell_share.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pelage {
namespace {

// Shells are as good and as cheap as need be.
constexpr CoatInView kFar{.apart = 0.1f, .flip = 0.001f, .strandSeconds = 1.0, .shellSeconds = 0.1};

float shareOf(CoatInView coat, Detail::Rule rule, float limit = 0.0f) {
    return shellShare({.rule = rule, .limit = limit}, coat);
}

TEST(ShellShare, IsNoneWhereEveryHairIsAskedFor) {
    EXPECT_EQ(shareOf(kFar, Detail::Rule::distance), 1.0f);
    EXPECT_EQ(shareOf(kFar, Detail::Rule::all), 0.0f);
    EXPECT_EQ(shareOf({}, Detail::Rule::distance), 0.0f);  // no fur
}

TEST(ShellShare, IsNoneWhereShellsCostMoreAndAllWhereTheyCostHalfAsMuch) {
    CoatInView coat = kFar;
    coat.shellSeconds = 1.0;
    EXPECT_EQ(shareOf(coat, Detail::Rule::distance), 0.0f);
    coat.shellSeconds = std::sqrt(0.5);
    EXPECT_NEAR(shareOf(coat, Detail::Rule::distance), 0.5f, 1e-4f);
    coat.shellSeconds = 0.5;
    EXPECT_EQ(shareOf(coat, Detail::Rule::distance), 1.0f);
}

TEST(ShellShare, KeepsToTheErrorThatIsAskedFor) {
    CoatInView coat = kFar;
    coat.flip = 0.05f;
    EXPECT_EQ(shareOf(coat, Detail::Rule::flip, 0.05f), 0.0f);
    EXPECT_EQ(shareOf(coat, Detail::Rule::flip, 0.1f), 1.0f);
    EXPECT_EQ(shareOf(coat, Detail::Rule::pixels, 0.1f), 0.0f);  // hairs stand 0.1 apart
    EXPECT_EQ(shareOf(coat, Detail::Rule::pixels, 0.2f), 1.0f);
    coat.apart = 1.0f;
    EXPECT_EQ(shareOf(coat, Detail::Rule::distance), 0.0f);
    coat.apart = 0.5f;
    EXPECT_EQ(shareOf(coat, Detail::Rule::distance), 1.0f);
}

TEST(ShellShare, NeverJumps) {
    float before = 0.0f;
    for (int i = 0; i <= 1000; ++i) {
        CoatInView coat = kFar;
        coat.shellSeconds = std::exp2(1.0 - 0.003 * i);
        coat.apart = std::exp2(0.5f - 0.002f * static_cast<float>(i));
        const float share = shareOf(coat, Detail::Rule::distance);
        EXPECT_GE(share, before);
        EXPECT_LE(share, before + 0.01f);
        before = share;
    }
    EXPECT_EQ(before, 1.0f);
}

}  // namespace
}  // namespace pelage
