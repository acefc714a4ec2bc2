// pace_test.cpp -- frames that are planned by what the frames before took keep to their time.
#include "core/pace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/strand.h"

namespace pelage {
namespace {

// Seconds of each of 300 frames on a machine on which work costs `perWork` and the rest `rest`,
// both give or take a fifth, where at most `most` work can be done.
std::vector<double> framesOf(double budget, double perWork, double rest, double most) {
    Pace pace;
    std::vector<double> frames;
    for (uint i = 0; i < 300; ++i) {
        const auto vary = [&](uint stream) {
            return 0.8 + 0.4 * static_cast<double>(rand01(2 * i + stream));
        };
        const double work = std::min(pace.workWithin(budget), most);
        const double working = work * perWork * vary(0), resting = rest * vary(1);
        pace.learn(work, working, resting);
        frames.push_back(working + resting);
    }
    return frames;
}

TEST(Pace, FramesKeepToTheirTimeOnFastAndSlowMachines) {
    for (const double perWork : {1e-10, 1e-8, 5e-8, 1e-6})
        for (const double rest : {1e-3, 0.01, 0.02}) {
            std::vector<double> frames = framesOf(0.033, perWork, rest, 1e12);
            std::sort(frames.begin(), frames.end());
            EXPECT_LE(frames[285], 0.040) << perWork << " " << rest;  // 95th percentile
            EXPECT_GE(frames[150], 0.025) << perWork << " " << rest;  // and the time is used
        }
}

TEST(Pace, WhereEverythingFitsEverythingMayBeDone) {
    Pace pace;
    for (int i = 0; i < 20; ++i) pace.learn(1e6, 0.001, 0.005);
    EXPECT_GE(pace.workWithin(0.033), 1e6);
}

TEST(Pace, SomeWorkAlwaysFits) {
    Pace pace;
    for (int i = 0; i < 20; ++i) pace.learn(1e6, 0.01, 10.0);
    EXPECT_GT(pace.workWithin(0.033), 1e5);
}

TEST(Pace, FramesWithoutWorkDoNotChangeWhatItCosts) {
    Pace pace;
    for (int i = 0; i < 20; ++i) pace.learn(1e6, 0.01, 0.01);
    const double before = pace.workWithin(0.033);
    for (int i = 0; i < 20; ++i) pace.learn(0.0, 0.001, 0.01);
    EXPECT_NEAR(pace.workWithin(0.033), before, 1e-3 * before);
}

}  // namespace
}  // namespace pelage
