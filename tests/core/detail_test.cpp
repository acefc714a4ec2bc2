// detail_test.cpp -- rules of detail as text.
#include "core/detail.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pelage {
namespace {

TEST(Detail, ReadsARuleATimeOrBoth) {
    using Rule = Detail::Rule;
    EXPECT_EQ(detailFromText("all"), (Detail{.rule = Rule::all}));
    EXPECT_EQ(detailFromText("distance"), (Detail{.rule = Rule::distance}));
    EXPECT_EQ(detailFromText("share:0.25"), (Detail{.rule = Rule::share, .limit = 0.25f}));
    EXPECT_EQ(detailFromText("pixels:2"), (Detail{.rule = Rule::pixels, .limit = 2.0f}));
    EXPECT_EQ(detailFromText("flip:0.05"), (Detail{.rule = Rule::flip, .limit = 0.05f}));
    EXPECT_EQ(detailFromText("ms:33"), (Detail{.rule = Rule::all, .milliseconds = 33.0f}));
    const Detail both{.rule = Rule::pixels, .limit = 0.5f, .milliseconds = 16.6f};
    EXPECT_EQ(detailFromText("pixels:0.5,ms:16.6"), both);
    EXPECT_EQ(detailFromText("ms:16.6,pixels:0.5"), both);
}

TEST(Detail, EveryRuleReadsBackFromItsText) {
    for (std::size_t rule = 0; rule < kDetailRules.size(); ++rule)
        for (const float ms : {0.0f, 33.0f, 1e-3f}) {
            Detail detail{.rule = static_cast<Detail::Rule>(rule), .milliseconds = ms};
            if (ruleOf(detail).format) detail.limit = 0.3f;
            EXPECT_EQ(detailFromText(textOf(detail)), detail) << textOf(detail);
        }
}

TEST(Detail, WhatIsNoDetailIsRefusedAndQuoted) {
    for (const char* text :
         {"",          ",",          "al",   "all,",   "all,all", "all,distance", "ms:33,ms:34",
          "ms",        "ms:",        "ms:0", "ms:nan", "share",   "share:0",      "share:1.01",
          "pixels:-1", "pixels:inf", "flip", "flip:0", "flip:2",  "all:1",        "pixels:1 "})
        try {
            detailFromText(text);
            ADD_FAILURE() << text;
        } catch (const std::runtime_error& error) {
            EXPECT_EQ(std::string(error.what()).find('"' + std::string(text) + '"'), 0u)
                << error.what();
        }
}

}  // namespace
}  // namespace pelage
