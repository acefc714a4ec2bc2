// text_test.cpp -- the promises of text.h.
#include "core/text.h"

#include <gtest/gtest.h>

#include <cstring>

#include "test_skins.h"

namespace pelage {
namespace {

using test::Draws;

TEST(FloatText, ReadsBackBitForBit) {
    Draws draws(32);
    for (int i = 0; i < 20000; ++i) {
        const uint bits = draws.below(0x7f800000u) | (draws.below(2) << 31);
        float number;
        std::memcpy(&number, &bits, sizeof number);
        const auto back = floatFromText(floatText(number));
        ASSERT_TRUE(back);
        EXPECT_EQ(std::memcmp(&*back, &number, sizeof number), 0);
    }
    EXPECT_EQ(floatText(-0.0f), "-0");
}

TEST(FloatText, IsShortAndHasNoExponentForWholeNumbers) {
    EXPECT_EQ(floatText(0.3f), "0.3");
    EXPECT_EQ(floatText(5e6f), "5000000");
    EXPECT_EQ(floatText(16777216.0f), "16777216");
    EXPECT_EQ(floatText(1e30f), "1e+30");
}

TEST(FloatFromText, IsEmptyUnlessAllIsOneFiniteNumber) {
    EXPECT_EQ(floatFromText("1e3"), 1000.0f);
    for (const char* wrong : {"", "nan", "inf", "-inf", "1x", "1e999", "--1", " 1"})
        EXPECT_FALSE(floatFromText(wrong)) << wrong;
}

TEST(InQuotes, IsOneShortLineWithoutControlCodes) {
    EXPECT_EQ(inQuotes("horse"), "\"horse\"");
    EXPECT_EQ(inQuotes("a\nb\x1b\x7f"), "\"a?b??\"");
    EXPECT_EQ(inQuotes(std::string(80, 'x')), '"' + std::string(80, 'x') + '"');
    EXPECT_EQ(inQuotes(std::string(81, 'x')), '"' + std::string(80, 'x') + "...\"");
}

}  // namespace
}  // namespace pelage
