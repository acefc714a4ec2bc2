// figures.h -- the figures of accuracy that Pelage publishes: said by the tests that hold it to
// them.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>

namespace pelage::test {

// Says in one line, which tests/figures.sh gathers, what was reached and what was allowed; nothing
// is expected. `row` orders the lines: H1... hair, R1... roots, I1... images, S1... shading, U1...
// layers from photographs.
inline void measured(const char* row, const char* what, double value, double most) {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    std::printf("figure | %s | %s | %.3g | at most %.3g | %s.%s |\n", row, what, value, most,
                test->test_suite_name(), test->name());
}

// The same, and expects value <= most.
inline void reached(const char* row, const char* what, double value, double most) {
    measured(row, what, value, most);
    EXPECT_LE(value, most) << row << ": " << what;
}

}  // namespace pelage::test
