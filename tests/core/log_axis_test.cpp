// log_axis_test.cpp -- the promises of log_axis.h.
#include "core/log_axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelage {
namespace {

LogAxis axisOf(double least, double greatest, double ratio, double length = 368.0) {
    LogAxis axis{.from = 0.0, .to = length};
    axis.hold(greatest);
    axis.hold(least);
    axis.widen(ratio);
    return axis;
}

TEST(LogAxis, WhatIsNotPositiveAndFiniteHasNoPlace) {
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1.0, infinite, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_FALSE(LogAxis::hasPlace(bad)) << bad;
    EXPECT_TRUE(LogAxis::hasPlace(1e-300));
}

TEST(LogAxis, EqualRatiosAreEqualDistances) {
    for (const bool falls : {false, true}) {
        LogAxis axis{.from = falls ? 300.0 : 20.0, .to = falls ? 20.0 : 300.0};
        axis.hold(0.5);
        axis.hold(40.0);
        EXPECT_NEAR(axis.place(0.5), axis.from, 1e-9);
        EXPECT_NEAR(axis.place(40.0), axis.to, 1e-9);
        EXPECT_NEAR(axis.place(10.0) - axis.place(2.0), axis.place(5.0) - axis.place(1.0), 1e-9);
        EXPECT_EQ(axis.place(2.0) < axis.place(1.0), falls);
    }
}

TEST(LogAxis, ThereIsRoomAtBothEndsAndAtLeastTheRatio) {
    for (const double greatest : {3.0, 3.1, 7.0, 3e4}) {
        const LogAxis axis = axisOf(3.0, greatest, 4.0);
        EXPECT_LT(axis.least, 3.0);
        EXPECT_GT(axis.greatest, greatest);
        EXPECT_NEAR(3.0 / axis.least, axis.greatest / greatest, 1e-9);
        EXPECT_GE(axis.greatest / axis.least, 4.0 * (1.0 - 1e-12));
    }
    const LogAxis empty = [] {
        LogAxis axis{.from = 0.0, .to = 1.0};
        axis.widen(4.0);
        return axis;
    }();
    EXPECT_NEAR(empty.place(1.0), 0.5, 1e-9);
}

TEST(LogAxis, TicksAreRoundGrowAndKeepApart) {
    for (const double most : {1.1, 2.1, 3.0, 6.0, 9.5, 40.0, 3000.0, 1e7, 1e30})
        for (const double least : {1e-9, 1.0, 1.3, 2.1, 2.6, 5.1, 8.0}) {
            const LogAxis axis = axisOf(least, least * most, 2.5);
            const std::vector<double> ticks = axis.ticks(40.0);
            EXPECT_GE(ticks.size(), 3u) << least << " to " << least * most;
            for (std::size_t i = 0; i < ticks.size(); ++i) {
                EXPECT_GE(ticks[i], axis.least);
                EXPECT_LE(ticks[i], axis.greatest);
                const double tenths =
                    10.0 * ticks[i] / std::pow(10.0, std::floor(std::log10(ticks[i]) + 1e-9));
                EXPECT_NEAR(tenths, std::round(tenths), 1e-6) << ticks[i];
                if (i > 0) {
                    EXPECT_GE(axis.place(ticks[i]) - axis.place(ticks[i - 1]), 40.0);
                }
            }
        }
}

TEST(LogAxis, TheFinestStepsAreTakenThatKeepApart) {
    LogAxis axis{.from = 0.0, .to = 100.0};
    axis.hold(1.0);
    axis.hold(10.0);
    using Values = std::vector<double>;
    EXPECT_EQ(axis.ticks(30.0), (Values{1, 2, 5, 10}));  // log10(2) = 0.301
    EXPECT_EQ(axis.ticks(31.0), (Values{1, 3, 10}));
    EXPECT_EQ(axis.ticks(12.0), (Values{1, 1.5, 2, 3, 5, 7, 10}));
    EXPECT_EQ(axis.ticks(50.0), (Values{1, 10}));
    EXPECT_EQ(axis.ticks(101.0), (Values{1}));
    EXPECT_EQ(axis.ticks(1.0).size(), 13u);
}

}  // namespace
}  // namespace pelage
