// warnings_test.cpp -- the promises of warnings.h.
#include "core/warnings.h"

#include <gtest/gtest.h>

namespace pelage {
namespace {

TEST(Warnings, AreToldOnceAndInTheirOrder) {
    Warnings warnings;
    for (const char* text : {"b", "a", "b", "a"}) warnings.add(text);
    EXPECT_EQ(warnings.take(), (std::vector<std::string>{"b", "a"}));
}

TEST(Warnings, AreNeverAFloodAndTheRestIsCounted) {
    Warnings warnings;
    for (int i = 0; i < 1000; ++i) warnings.add(std::to_string(i));
    const std::vector<std::string> lines = warnings.take();
    ASSERT_EQ(lines.size(), 41u);
    EXPECT_EQ(lines[39], "39");
    EXPECT_EQ(lines[40], "and 960 more warnings");
}

TEST(Warnings, OfNothingAreNone) { EXPECT_TRUE(Warnings().take().empty()); }

}  // namespace
}  // namespace pelage
