// morton_test.cpp -- the promises of morton.h.
#include "core/morton.h"

#include <gtest/gtest.h>

#include <bit>

namespace pelage {
namespace {

TEST(SpreadBits, PutsTwoZerosAfterEachOfTheLow21Bits) {
    for (int bit = 0; bit < 64; ++bit) {
        const std::uint64_t wanted = bit < 21 ? std::uint64_t{1} << 3 * bit : 0;
        EXPECT_EQ(spreadBits(std::uint64_t{1} << bit), wanted) << bit;
    }
    EXPECT_EQ(std::popcount(spreadBits(~std::uint64_t{0})), 21);
}

TEST(MortonCode, HoldsTheBitsOfTheThreeCellsInTurn) {
    const vec3 lower(-3.0f, 5.0f, 7.0f);
    EXPECT_EQ(mortonCode(lower, lower, 10.0f), 0u);
    EXPECT_EQ(mortonCode(lower + vec3(0.15f, 0, 0), lower, 10.0f), 1u);
    EXPECT_EQ(mortonCode(lower + vec3(0, 0.15f, 0), lower, 10.0f), 2u);
    EXPECT_EQ(mortonCode(lower + vec3(0, 0, 0.15f), lower, 10.0f), 4u);
    EXPECT_EQ(mortonCode(lower + vec3(0.25f, 0.15f, 0.35f), lower, 10.0f),
              0b101110u);  // of cell 2, 1, 3
}

TEST(MortonCode, NearNumbersAreNearPlaces) {
    // Every run of 8^k codes that begins at a multiple of 8^k is a cube of 2^k cells a side.
    for (std::uint64_t z = 0; z < 8; ++z)
        for (std::uint64_t y = 0; y < 8; ++y)
            for (std::uint64_t x = 0; x < 8; ++x) {
                const vec3 place = vec3(x, y, z) + 0.5f;
                const std::uint64_t code = mortonCode(place, vec3(0.0f), 1.0f);
                EXPECT_LT(code, 512u);
                EXPECT_EQ(code / 8, mortonCode(vec3(x / 2, y / 2, z / 2) + 0.5f, vec3(0), 1.0f));
            }
}

TEST(MortonCode, PlacesOutsideCountAsTheNearestCell) {
    const std::uint64_t last = mortonCode(vec3(kLastCell), vec3(0.0f), 1.0f);
    EXPECT_EQ(last, (std::uint64_t{1} << 63) - 1);
    EXPECT_EQ(mortonCode(vec3(1e30f), vec3(0.0f), 1.0f), last);
    EXPECT_EQ(mortonCode(vec3(-1e30f), vec3(0.0f), 1.0f), 0u);
}

}  // namespace
}  // namespace pelage
