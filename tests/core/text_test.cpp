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

TEST(MarkupText, HoldsNoTagsEntitiesQuotesOrControlCodes) {
    EXPECT_EQ(markupText("a<b>&\"c\"\n"), "a&lt;b&gt;&amp;&quot;c&quot; ");
}

TEST(CsvField, IsQuotedWhereItHasToBe) {
    EXPECT_EQ(csvField("plain text"), "plain text");
    EXPECT_EQ(csvField(""), "");
    EXPECT_EQ(csvField("a,b"), "\"a,b\"");
    EXPECT_EQ(csvField("5\" wide"), "\"5\"\" wide\"");
    EXPECT_EQ(csvField("two\nlines"), "\"two\nlines\"");
    EXPECT_EQ(csvField("cr\r"), "\"cr\r\"");
}

// The vectors of RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandardWithPadding) {
    const std::pair<std::string_view, const char*> vectors[] = {{"", ""},
                                                                {"f", "Zg=="},
                                                                {"fo", "Zm8="},
                                                                {"foo", "Zm9v"},
                                                                {"foob", "Zm9vYg=="},
                                                                {"fooba", "Zm9vYmE="},
                                                                {"foobar", "Zm9vYmFy"}};
    for (const auto& [text, coded] : vectors)
        EXPECT_EQ(base64(std::as_bytes(std::span(text))), coded);
}

}  // namespace
}  // namespace pelage
