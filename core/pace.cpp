// pace.cpp -- how much work fits a frame.
#include "pace.h"

#include <algorithm>

namespace pelage {
namespace {

constexpr double kAimed = 0.85;      // share of the time that is planned; frames vary
constexpr double kLeastRoom = 0.15;  // share that is left to work, whatever else there is to do
constexpr double kLearning = 0.5;    // weight of the last frame
constexpr double kLeastWork = 1e4;   // less of it takes too short a time to be measured

}  // namespace

double Pace::workWithin(double seconds) const {
    return std::max(kAimed * seconds - rest_, kLeastRoom * seconds) / perWork_;
}

double Pace::secondsOf(double work) const { return rest_ + perWork_ * work; }

void Pace::learn(double work, double workSeconds, double restSeconds) {
    if (work > kLeastWork) perWork_ += kLearning * (workSeconds / work - perWork_);
    rest_ += kLearning * (restSeconds - rest_);
}

}  // namespace pelage
