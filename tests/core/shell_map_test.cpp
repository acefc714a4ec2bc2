// shell_map_test.cpp -- the promises of shell_map.h: ranks of pictures, and levels that cover
// alike.
#include "core/shell_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace pelage {
namespace {

constexpr float kHeights[] = {0.001f, 0.1f, 0.25f, 0.5f, 0.75f, 0.9f, 0.99f, 1.0f};

Plane rampOf(ivec2 size) {  // 0 to 1, all values different
    Plane plane{size, {}};
    const auto count = static_cast<float>(pixelCount(size));
    for (std::size_t i = 0; i < pixelCount(size); ++i)
        plane.values.push_back((static_cast<float>(i) + 0.5f) / count);
    return plane;
}

std::vector<int> codesOf(const ShellLevel& level) {
    std::vector<int> codes;
    for (const ShellTexel& texel : level.texels) codes.push_back(texel.height);
    return codes;
}

void expectCoverageKept(const ShellMap& map, const char* what) {
    for (std::size_t i = 1; i < map.levels.size(); ++i) {
        const double half = 0.5 / static_cast<double>(map.levels[i].texels.size());
        for (const float t : kHeights)
            EXPECT_NEAR(coverage(map.levels[i], t), coverage(map.levels[0], t), half + 1e-9)
                << what << " level " << i << " height " << t;
    }
}

TEST(ShellMap, ALayerIsWhereHairReaches) {
    EXPECT_FALSE(reaches({0, 7}, 1e-9f)) << "bare";
    EXPECT_TRUE(reaches({1, 7}, 1e-9f));
    EXPECT_TRUE(reaches({65535, 7}, 1.0f));
    EXPECT_FALSE(reaches({65534, 7}, 1.0f));
    EXPECT_TRUE(reaches({32768, 7}, 0.5f));
    EXPECT_FALSE(reaches({32767, 7}, 0.5f));
    const ShellLevel level{{2, 2}, {{0, 0}, {10000, 0}, {40000, 0}, {65535, 0}}};
    EXPECT_EQ(coverage(level, 0.001f), 0.75);
    EXPECT_EQ(coverage(level, 0.5f), 0.5);
    EXPECT_EQ(coverage(level, 1.0f), 0.25);
}

TEST(ShellMap, LevelsAreHalvedDownToOneTexel) {
    EXPECT_EQ(halfSize({7, 1}), ivec2(3, 1));
    EXPECT_EQ(texelsWithLevels({1, 1}), 1u);
    EXPECT_EQ(texelsWithLevels({4, 4}), 21u);
    EXPECT_EQ(texelsWithLevels({5, 3}), 15u + 2u + 1u);
    EXPECT_EQ(texelsWithLevels({256, 256}), 87381u);
    for (const ivec2 size : {ivec2(1, 1), ivec2(8, 8), ivec2(5, 3), ivec2(1, 9), ivec2(33, 100)}) {
        const ShellMap map = rawMap(rampOf(size), 1);
        std::size_t texels = 0;
        ivec2 expected = size;
        for (const ShellLevel& level : map.levels) {
            EXPECT_EQ(level.size, expected);
            EXPECT_EQ(level.texels.size(), pixelCount(expected));
            texels += level.texels.size();
            expected = halfSize(expected);
        }
        EXPECT_EQ(map.levels.back().size, ivec2(1));
        EXPECT_EQ(texels, texelsWithLevels(size));
    }
}

TEST(ShellMap, RanksOfFourValuesAreTheirHeights) {
    // From the top the places have ranks 1/8, 3/8, 5/8 and 7/8; with a coverage of 1/2 two are
    // hair, and (1 - t)^2 / 2 is 1/8 at t = 1/2 and 3/8 at t = 1 - sqrt(3)/2.
    const ShellMap map = rankedMap({{2, 2}, {5.0f, -3.0f, 0.25f, 9.0f}}, {0.5f, 1.0f}, 1);
    const auto low = static_cast<int>(std::lround(65535.0 * (1.0 - std::sqrt(0.75))));
    EXPECT_EQ(codesOf(map.levels[0]), (std::vector{low, 0, 0, 32768}));
    // With a taper of 1/2 the narrower one stands at full length, and the other up to
    // 2 (1 - sqrt(3)/2).
    const ShellMap blunt = rankedMap({{2, 2}, {5.0f, -3.0f, 0.25f, 9.0f}}, {0.5f, 0.5f}, 1);
    EXPECT_EQ(codesOf(blunt.levels[0]), (std::vector{2 * low, 0, 0, 65535}));
    // Without taper all hair is long.
    const ShellMap even = rankedMap({{2, 2}, {5.0f, -3.0f, 0.25f, 9.0f}}, {0.75f, 0.0f}, 1);
    EXPECT_EQ(codesOf(even.levels[0]), (std::vector{65535, 0, 65535, 65535}));
}

TEST(ShellMap, LayersCoverWhatTheCutSaysToHalfATexel) {
    for (const int side : {1, 3, 64, 100, 256})
        for (const ShellCut cut : {ShellCut{0.5f, 1.0f}, {1.0f, 1.0f}, {0.9f, 0.5f}, {0.1f, 0.0f}})
            for (const int mask : {1, 5}) {
                const Plane noise = noisePicture({.seed = 3, .side = side, .mask = mask});
                const ShellMap map = rankedMap(noise, cut, 1);
                for (const float t : kHeights) {
                    const double width = 1.0 - static_cast<double>(cut.taper * t);
                    const double area = static_cast<double>(cut.coverage) * width * width;
                    EXPECT_NEAR(coverage(map.levels[0], t), area, 0.5 / (side * side) + 3e-5)
                        << side << " taper " << cut.taper << " mask " << mask << " height " << t;
                }
            }
}

TEST(ShellMap, EveryLayerOfEveryLevelCoversWhatItCoversInTheTile) {
    const Plane noise = noisePicture({.side = 256});
    expectCoverageKept(rankedMap(noise, {0.5f, 1.0f}, 1), "noise");
    expectCoverageKept(rankedMap(noise, {0.1f, 0.0f}, 1), "short of hair");
    expectCoverageKept(rankedMap(noisePicture({.side = 100}), {0.7f, 0.8f}, 1), "odd sides");
    expectCoverageKept(rawMap(rampOf({33, 100}), 1), "ramp");
    expectCoverageKept(hairMap({}), "hairs");
}

TEST(ShellMap, CoverageIsKeptTwoThousandthsAtLevelFive) {
    const ShellMap map = rankedMap(noisePicture({.side = 512}), {1.0f, 1.0f}, 1);
    ASSERT_EQ(map.levels[5].size, ivec2(16));
    double most = 0.0;
    for (int i = 1; i <= 200; ++i) {
        const auto t = static_cast<float>(i) / 200.0f;
        most = std::max(most, std::abs(coverage(map.levels[5], t) - coverage(map.levels[0], t)));
    }
    EXPECT_LE(most, 0.002);
}

// A check of the check: the averages without their order, which is what fur must not be drawn with.
TEST(ShellMap, AveragesAloneWouldMakeFurBald) {
    const ShellMap map = rankedMap(noisePicture({.side = 256}), {1.0f, 0.0f}, 1);
    const Plane noise = noisePicture({.side = 256});
    std::vector<float> ranks(noise.values.size());
    std::vector<std::size_t> order(ranks.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::sort(order, {}, [&](std::size_t i) { return noise.values[i]; });
    for (std::size_t i = 0; i < order.size(); ++i)
        ranks[order[i]] = static_cast<float>(i) / static_cast<float>(order.size());
    int above = 0;  // of the means of 16x16 texels, over a threshold that a tenth of them passes
    for (int y = 0; y < 256; y += 16)
        for (int x = 0; x < 256; x += 16) {
            double sum = 0.0;
            for (int j = 0; j < 16; ++j)
                for (int i = 0; i < 16; ++i)
                    sum +=
                        static_cast<double>(ranks[static_cast<std::size_t>((y + j) * 256 + x + i)]);
            above += sum / 256.0 > 0.9;
        }
    EXPECT_EQ(above, 0);
    EXPECT_NEAR(coverage(map.levels[4], 1.0f), coverage(map.levels[0], 1.0f), 0.5 / 256);
}

TEST(ShellMap, AveragesOfALevelArePutInOrderAndTakeTheHeightsOfTheTile) {
    // Means of the quarters: 0.25, 0.1, 0.9 and 0.5. The heights of the tile are at ranks 2, 6, 10
    // and 14 of 16.
    const ShellMap map = rawMap({{4, 4},
                                 {0.20f, 0.30f, 0.00f, 0.10f,  //
                                  0.25f, 0.25f, 0.20f, 0.10f,  //
                                  0.90f, 0.95f, 0.50f, 0.50f,  //
                                  0.85f, 0.90f, 0.40f, 0.60f}},
                                1);
    const auto code = [](float height) { return static_cast<int>(std::lround(height * 65535.0f)); };
    EXPECT_EQ(codesOf(map.levels[1]),
              (std::vector{code(0.25f), code(0.10f), code(0.90f), code(0.50f)}));
    EXPECT_EQ(codesOf(map.levels[2]), std::vector{code(0.40f)});
}

TEST(ShellMap, TexelsOfOddSidesCountByTheirArea) {
    // Of 3 texels each of the one below has a third: mean 0.4, and the height of the middle rank.
    const ShellMap three = rawMap({{3, 1}, {0.9f, 0.1f, 0.2f}}, 1);
    EXPECT_EQ(codesOf(three.levels[1]), std::vector{static_cast<int>(std::lround(0.2 * 65535.0))});
    // Of 5 texels two and a half each: (0.5 + 0.5 + 0.45) / 2.5 = 0.58 and (0.45 + 0.6 + 0.6) / 2.5
    // = 0.66, so that the right one is higher; with two or three texels it would be the left one.
    const ShellMap five = rawMap({{5, 1}, {0.5f, 0.5f, 0.9f, 0.6f, 0.6f}}, 1);
    const std::vector<int> codes = codesOf(five.levels[1]);
    EXPECT_LT(codes[0], codes[1]);
}

TEST(ShellMap, AnIdOfALevelIsThatOfTheHighestHairBelow) {
    const ShellMap map = rankedMap(noisePicture({.side = 64}), {0.5f, 1.0f}, 1);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            ShellTexel highest;
            for (const ivec2 d : {ivec2(0, 0), ivec2(1, 0), ivec2(0, 1), ivec2(1, 1)}) {
                const ShellTexel t =
                    map.levels[0]
                        .texels[static_cast<std::size_t>((2 * y + d.y) * 64 + 2 * x + d.x)];
                if (t.height > highest.height) highest = t;
            }
            if (highest.height > 0) {
                EXPECT_EQ(map.levels[1].texels[static_cast<std::size_t>(y * 32 + x)].id,
                          highest.id);
            }
        }
}

TEST(ShellMap, EqualValuesComeInAnOrderOfChance) {
    const Plane flat{{64, 64}, std::vector<float>(4096, 0.5f)};
    const ShellMap map = rankedMap(flat, {0.5f, 0.0f}, 1);
    EXPECT_EQ(coverage(map.levels[0], 1.0f), 0.5);
    for (int half = 0; half < 2; ++half) {  // 4 standard deviations
        int left = 0, top = 0;
        for (int i = 0; i < 2048; ++i) {
            const int row = i / 32, column = i % 32 + 32 * half;
            left += map.levels[0].texels[static_cast<std::size_t>(64 * row + column)].height > 0;
            top += map.levels[0].texels[static_cast<std::size_t>(2048 * half + i)].height > 0;
        }
        EXPECT_NEAR(left, 1024, 90);
        EXPECT_NEAR(top, 1024, 90);
    }
}

TEST(ShellMap, EachPeakIsOneHairAndOwnsTheWaysUpToIt) {
    // Two hills with a valley between them; the row repeats, so that the slopes at both ends are
    // those of different hills.
    const ShellMap map = rawMap({{8, 1}, {0.3f, 0.6f, 0.4f, 0.2f, 0.5f, 0.9f, 0.7f, 0.1f}}, 1);
    std::vector<int> ids;
    for (const ShellTexel& texel : map.levels[0].texels) ids.push_back(texel.id);
    EXPECT_EQ(ids[0], ids[1]);
    EXPECT_EQ(ids[2], ids[1]);
    for (const std::size_t i : {3u, 4u, 6u, 7u}) EXPECT_EQ(ids[i], ids[5]) << i;
    EXPECT_NE(ids[1], ids[5]);
    // Over the edge the last texel is a neighbor of the first.
    const ShellMap edge = rawMap({{5, 1}, {0.8f, 0.1f, 0.3f, 0.2f, 0.7f}}, 1);
    EXPECT_EQ(edge.levels[0].texels[4].id, edge.levels[0].texels[0].id);
}

TEST(ShellMap, IdsOfNoiseAreUniform) {
    const ShellMap map = rankedMap(noisePicture({.side = 256, .mask = 3}), {1.0f, 1.0f}, 1);
    std::set<int> ids;
    for (const ShellTexel& texel : map.levels[0].texels) ids.insert(texel.id);
    ASSERT_GT(ids.size(), 2000u);
    int cells[16] = {};
    for (const int id : ids) ++cells[id / 4096];
    const double expected = static_cast<double>(ids.size()) / 16.0;
    double chi = 0.0;
    for (const int cell : cells) chi += (cell - expected) * (cell - expected) / expected;
    EXPECT_LT(chi, 40.0);  // 15 degrees of freedom: p > 0.0005
}

TEST(ShellMap, ValuesAreHeightsAndNothingIsBare) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const ShellMap map = rawMap({{6, 1}, {0.0f, nan, -2.0f, 1e-9f, 0.5f, 7.0f}}, 1);
    EXPECT_EQ(codesOf(map.levels[0]), (std::vector{0, 0, 0, 1, 32768, 65535}));
}

}  // namespace
}  // namespace pelage
