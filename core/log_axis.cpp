// log_axis.cpp -- logarithms, and steps of a decade.
#include "log_axis.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace pelage {
namespace {

constexpr double kTens[] = {1.0};
constexpr double kThrees[] = {1.0, 3.0};
constexpr double kHalves[] = {1.0, 2.0, 5.0};
constexpr double kMiddle[] = {1.0, 1.5, 2.0, 3.0, 5.0, 7.0};
constexpr double kFine[] = {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0};

std::vector<double> stepsBetween(double least, double greatest, std::span<const double> steps) {
    std::vector<double> found;
    for (double power = std::floor(std::log10(least)); std::pow(10.0, power) <= greatest; ++power)
        for (const double step : steps) {
            const double value = step * std::pow(10.0, power);
            if (value >= least && value <= greatest) found.push_back(value);
        }
    return found;
}

}  // namespace

bool LogAxis::hasPlace(double value) { return value > 0.0 && std::isfinite(value); }

void LogAxis::hold(double value) {
    least = least > 0.0 ? std::min(least, value) : value;
    greatest = std::max(greatest, value);
}

void LogAxis::widen(double ratio) {
    if (greatest <= 0.0) least = greatest = 1.0;
    const double room =
        std::max(std::pow(greatest / least, 0.08), std::sqrt(ratio * least / greatest));
    least /= room;
    greatest *= room;
}

double LogAxis::place(double value) const {
    return from + (to - from) * std::log(value / least) / std::log(greatest / least);
}

std::vector<double> LogAxis::ticks(double apart) const {
    const auto near = [&](double a, double b) { return std::abs(place(b) - place(a)) < apart; };
    for (const std::span<const double> steps :
         {std::span<const double>(kFine), {kMiddle}, {kHalves}, {kThrees}}) {
        std::vector<double> found = stepsBetween(least, greatest, steps);
        if (std::ranges::adjacent_find(found, near) == found.end()) return found;
    }
    std::vector<double> kept;
    for (const double ten : stepsBetween(least, greatest, kTens))
        if (kept.empty() || !near(kept.back(), ten)) kept.push_back(ten);
    return kept;
}

}  // namespace pelage
