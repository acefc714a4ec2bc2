// text_scan_test.cpp -- the promises of text_scan.h.
#include "core/text_scan.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "reading.h"

namespace pelage {
namespace {

using test::bytesOf;
using test::refusal;

// A scan that holds its bytes.
struct Text {
    std::vector<std::byte> bytes;
    TextScan scan;
    explicit Text(std::string_view text) : bytes(bytesOf(text)), scan("horse.obj", bytes) {}
};

TEST(TextScan, LinesEndInNewlineOrCarriageReturnOrBoth) {
    Text text("a\nb\r\nc\r\rd");
    std::string found;
    while (text.scan.nextContent()) {
        found += std::string(text.scan.word()) + std::to_string(text.scan.line()) + ' ';
        text.scan.nextLine();
    }
    EXPECT_EQ(found, "a1 b2 c3 d5 ");
    EXPECT_TRUE(text.scan.atEnd());
    EXPECT_EQ(text.scan.bytesLeft(), 0u);
}

TEST(TextScan, ABackslashJoinsALineWithTheNext) {
    Text text("1 2 \\\n3\\\r\n 4\n5");
    for (const std::int64_t number : {1, 2}) EXPECT_EQ(text.scan.integer("n"), number);
    EXPECT_EQ(text.scan.line(), 1u);
    EXPECT_EQ(text.scan.integer("n"), 3);
    EXPECT_EQ(text.scan.integer("n"), 4);
    EXPECT_TRUE(text.scan.atLineEnd());
    EXPECT_EQ(text.scan.line(), 3u);
    EXPECT_TRUE(text.scan.nextContent());
    EXPECT_EQ(text.scan.integer("n"), 5);
    EXPECT_EQ(text.scan.line(), 4u);
}

TEST(TextScan, FromAHashThatBeginsAWordTheLineIsAComment) {
    EXPECT_EQ(Text("a#b").scan.word(), "a#b");
    Text text("# first\n  v 1 # 2\n\t# third\n4");
    EXPECT_TRUE(text.scan.nextContent());
    EXPECT_EQ(text.scan.line(), 2u);
    EXPECT_EQ(text.scan.word(), "v");
    EXPECT_EQ(text.scan.tryNumber(), 1.0f);
    EXPECT_TRUE(text.scan.atLineEnd());
    EXPECT_EQ(text.scan.word(), "");
    EXPECT_FALSE(text.scan.tryNumber());
    EXPECT_TRUE(text.scan.nextContent());
    EXPECT_EQ(text.scan.line(), 4u);
}

TEST(TextScan, TheRestOfALineIsWithoutBlanksAroundIt) {
    Text text("usemtl \t grey fell \t\nnext");
    EXPECT_EQ(text.scan.word(), "usemtl");
    EXPECT_EQ(text.scan.rest(), "grey fell");
    EXPECT_EQ(text.scan.rest(), "");
    EXPECT_EQ(text.scan.line(), 1u);
}

TEST(TextScan, RefusalsNameFileAndLine) {
    Text text("\n\nv 1 x");
    EXPECT_TRUE(text.scan.nextContent());
    text.scan.word();
    text.scan.tryNumber();
    EXPECT_EQ(refusal([&] { text.scan.tryNumber(); }), "horse.obj: line 3: \"x\" is not a number");
    EXPECT_EQ(refusal([&] { text.scan.number("a coordinate"); }),
              "horse.obj: line 3: ends where a coordinate is expected");
    EXPECT_EQ(refusal([&] { text.scan.integer("a corner"); }),
              "horse.obj: line 3: ends where a corner is expected");
    EXPECT_EQ(refusal([&] { text.scan.refuseAt(7, "is odd"); }), "horse.obj: line 7: is odd");
}

TEST(TextScan, NumbersAreFiniteOrRefused) {
    for (const char* good : {"1", "+1", "1.0", "1e0", "10e-1"})
        EXPECT_EQ(Text(good).scan.number("n"), 1.0f) << good;
    EXPECT_EQ(Text("1e-60").scan.number("n"), 0.0f);  // less than a float holds
    for (const char* bad :
         {"1e39", "nan", "inf", "-inf", "1e400", "+-1", "1,5", "0x1", "1e", "--1"})
        EXPECT_NE(refusal([&] { Text(bad).scan.number("n"); }), "(not refused)") << bad;
}

TEST(TextScan, IntegersAreWholeOrRefused) {
    EXPECT_EQ(Text("-9223372036854775808").scan.tryInteger(), INT64_MIN);
    EXPECT_EQ(Text("+7").scan.tryInteger(), 7);
    EXPECT_FALSE(Text(" \n").scan.tryInteger());
    for (const char* bad : {"1.0", "9223372036854775808", "one", "1/2"})
        EXPECT_NE(refusal([&] { Text(bad).scan.tryInteger(); }), "(not refused)") << bad;
}

}  // namespace
}  // namespace pelage
