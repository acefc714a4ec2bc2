// pressure.cpp -- valuators and held keys as a number from 0 to 1.
#include "app/pressure.h"

#include <algorithm>
#include <cstddef>

namespace pelage {

std::optional<float> pressureIn(const PressureAxis& axis, std::span<const unsigned char> mask,
                                std::span<const double> values) {
    const auto has = [&](std::size_t n) {
        return n / 8 < mask.size() && ((mask[n / 8] >> (n % 8)) & 1) != 0;
    };
    const auto number = static_cast<std::size_t>(axis.number);
    if (!has(number) || !(axis.greatest > axis.least)) return std::nullopt;
    std::size_t place = 0;
    for (std::size_t n = 0; n < number; ++n) place += has(n) ? 1 : 0;
    if (place >= values.size()) return std::nullopt;
    const double share = (values[place] - axis.least) / (axis.greatest - axis.least);
    return static_cast<float>(std::clamp(share, 0.0, 1.0));
}

float HeldPressure::at(double seconds, bool held) {
    const double passed = std::max(seconds - seconds_, 0.0) / kSeconds;
    const float change = static_cast<float>(passed) * (1.0f - kLight);
    pressure_ = std::clamp(pressure_ + (held_ ? -change : change), kLight, 1.0f);
    seconds_ = seconds;
    held_ = held;
    return pressure_;
}

}  // namespace pelage
