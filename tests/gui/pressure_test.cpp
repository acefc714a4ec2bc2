// pressure_test.cpp -- how hard the hand presses, without a pen: events as a driver would send
// them.
#include "app/pressure.h"

#include <gtest/gtest.h>

#include <array>

namespace pelage {
namespace {

// Valuator 2 of a tablet with 2048 levels.
constexpr PressureAxis kTablet{11, 2, 0.0, 2047.0};

TEST(Pressure, IsTheValuatorsShareOfItsRange) {
    constexpr std::array<unsigned char, 1> all{0b111};
    constexpr std::array<double, 3> values{1000.0, 700.0, 1023.5};
    EXPECT_FLOAT_EQ(*pressureIn(kTablet, all, values), 0.5f);
    constexpr PressureAxis signedAxis{11, 0, -1000.0, 3000.0};
    EXPECT_FLOAT_EQ(*pressureIn(signedAxis, all, values), 0.5f);
}

TEST(Pressure, ValuesArePackedByTheMask) {
    constexpr std::array<double, 2> values{700.0, 2047.0};
    constexpr std::array<unsigned char, 2> sparse{0b110, 0b0};
    EXPECT_FLOAT_EQ(*pressureIn(kTablet, sparse, values), 1.0f);
    constexpr PressureAxis high{11, 9, 0.0, 2800.0};
    constexpr std::array<unsigned char, 2> secondByte{0b1, 0b11};
    constexpr std::array<double, 3> three{1.0, 2.0, 700.0};
    EXPECT_FLOAT_EQ(*pressureIn(high, secondByte, three), 0.25f);
}

TEST(Pressure, IsNotToldByEventsWithoutIt) {
    constexpr std::array<double, 2> values{1000.0, 700.0};
    constexpr std::array<unsigned char, 1> motion{0b011};
    EXPECT_FALSE(pressureIn(kTablet, motion, values));
    EXPECT_FALSE(pressureIn(kTablet, {}, values));
    constexpr std::array<unsigned char, 1> all{0b111};
    EXPECT_FALSE(pressureIn(kTablet, all, values)) << "fewer values than the mask names";
    constexpr PressureAxis noRange{11, 1, 5.0, 5.0};
    EXPECT_FALSE(pressureIn(noRange, all, values));
}

TEST(Pressure, OutsideItsRangeIsClamped) {
    constexpr std::array<unsigned char, 1> only{0b100};
    constexpr std::array<double, 1> above{9000.0}, below{-5.0};
    EXPECT_EQ(*pressureIn(kTablet, only, above), 1.0f);
    EXPECT_EQ(*pressureIn(kTablet, only, below), 0.0f);
}

TEST(HeldPressure, FallsWhileTheKeyIsHeldAndComesBack) {
    HeldPressure pressure(10.0, false);
    EXPECT_EQ(pressure.at(10.5, false), 1.0f);
    pressure.at(10.5, true);
    const float half = pressure.at(10.5 + 0.5 * HeldPressure::kSeconds, true);
    EXPECT_NEAR(half, 0.5f * (1.0f + HeldPressure::kLight), 1e-5f);
    EXPECT_EQ(pressure.at(20.0, true), HeldPressure::kLight);
    EXPECT_EQ(pressure.at(20.0, false), HeldPressure::kLight);
    EXPECT_NEAR(pressure.at(20.0 + 0.5 * HeldPressure::kSeconds, false), half, 1e-5f);
    EXPECT_EQ(pressure.at(30.0, false), 1.0f);
}

TEST(HeldPressure, AStrokeBegunWithTheKeyBeginsLight) {
    EXPECT_EQ(HeldPressure(3.0, true).at(3.0, true), HeldPressure::kLight);
    EXPECT_EQ(HeldPressure(3.0, false).at(3.0, false), 1.0f);
}

}  // namespace
}  // namespace pelage
