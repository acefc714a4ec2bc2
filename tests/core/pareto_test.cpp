// pareto_test.cpp -- the promises of pareto.h, by hand.
#include "core/pareto.h"

#include <gtest/gtest.h>

#include <limits>

namespace pelage {
namespace {

using Front = std::vector<std::size_t>;

TEST(Pareto, HoldsWhatNoOtherBeatsFromTheFastestToTheSlowest) {
    const std::vector<Cost> costs = {{4, 1}, {1, 9}, {2, 5}, {3, 6}, {5, 2}, {2.5, 4}};
    EXPECT_EQ(paretoFront(costs), (Front{1, 2, 5, 0}));
}

TEST(Pareto, OneThatIsAsFastAndLessExactIsBeaten) {
    EXPECT_EQ(paretoFront(std::vector<Cost>{{1, 3}, {1, 2}, {2, 2}}), (Front{1}));
}

TEST(Pareto, OfEqualOnesTheFirstCounts) {
    EXPECT_EQ(paretoFront(std::vector<Cost>{{2, 1}, {1, 2}, {1, 2}, {2, 1}}), (Front{1, 0}));
}

TEST(Pareto, WhatIsNotFiniteIsLeftOut) {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(
        paretoFront(std::vector<Cost>{{nan, 0}, {0, nan}, {-infinite, 1}, {3, 3}, {0, infinite}}),
        (Front{3}));
    EXPECT_TRUE(paretoFront({}).empty());
}

}  // namespace
}  // namespace pelage
