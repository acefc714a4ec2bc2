// stratified_test.cpp -- places that fill a square evenly.
#include "core/stratified.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

namespace pelage {
namespace {

TEST(Stratified, OfThePlacesOneLiesInEachCellOfEveryGrid) {
    for (const uint seed : {0u, 1u, 123456u}) {
        for (uint power = 0; power <= 8; ++power) {
            const uint count = 1u << power;
            for (uint wide = 0; wide <= power; ++wide) {
                std::set<std::pair<uint, uint>> cells;
                for (uint i = 0; i < count; ++i) {
                    const vec2 place = stratified(i, seed);
                    EXPECT_TRUE(place.x >= 0.0f && place.x < 1.0f);
                    EXPECT_TRUE(place.y >= 0.0f && place.y < 1.0f);
                    cells.insert(
                        {static_cast<uint>(place.x * static_cast<float>(1u << wide)),
                         static_cast<uint>(place.y * static_cast<float>(1u << (power - wide)))});
                }
                EXPECT_EQ(cells.size(), count) << power << " " << wide << " seed " << seed;
            }
        }
    }
}

TEST(Stratified, EachPlaceIsUniformAndSequencesAreIndependent) {
    // Means over seeds of x, y, their squares and what two sequences have in common.
    constexpr uint kSeeds = 40000;
    for (const uint index : {0u, 5u}) {
        double x = 0.0, xx = 0.0, y = 0.0, xy = 0.0, both = 0.0;
        for (uint seed = 0; seed < kSeeds; ++seed) {
            const auto a = glm::dvec2(stratified(index, 3 * seed)) - 0.5;
            const auto b = glm::dvec2(stratified(index, 3 * seed + 1)) - 0.5;
            x += a.x / kSeeds;
            y += a.y / kSeeds;
            xx += a.x * a.x / kSeeds;
            xy += a.x * a.y / kSeeds;
            both += a.x * b.x / kSeeds;
        }
        // 4 standard deviations.
        EXPECT_NEAR(x, 0.0, 0.0058);
        EXPECT_NEAR(y, 0.0, 0.0058);
        EXPECT_NEAR(xx, 1.0 / 12.0, 0.0015);
        EXPECT_NEAR(xy, 0.0, 0.0017);
        EXPECT_NEAR(both, 0.0, 0.0017);
    }
}

}  // namespace
}  // namespace pelage
