// pressure.h -- how hard the hand presses: what a pen tells, and what a held key stands for.
#pragma once

#include <optional>
#include <span>

namespace pelage {

// The valuator of an input device that is its pressure.
struct PressureAxis {
    int device = 0;
    int number = 0;  // of the valuator, >= 0
    double least = 0.0, greatest = 1.0;
};

// The pressure in an event, [0,1]; nothing when the event does not tell. Bit n of the mask (byte
// n / 8, lowest bit first) says that valuator n is in it; the values of those are packed.
std::optional<float> pressureIn(const PressureAxis& axis, std::span<const unsigned char> mask,
                                std::span<const double> values);

// The pressure of a hand without a pen: it falls to a light touch while a key is held, and comes
// back when it is not, so that strokes taper.
class HeldPressure {
public:
    static constexpr float kLight = 0.15f;
    static constexpr double kSeconds = 0.6;  // from the one to the other

    HeldPressure() = default;
    HeldPressure(double seconds, bool held)
        : pressure_(held ? kLight : 1.0f), seconds_(seconds), held_(held) {}

    // At a later time; `held` is how the key is from now on.
    float at(double seconds, bool held);

private:
    float pressure_ = 1.0f;
    double seconds_ = 0.0;
    bool held_ = false;
};

}  // namespace pelage
